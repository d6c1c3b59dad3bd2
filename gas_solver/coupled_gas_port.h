// The gas of a coupled run with its files: results, checkpoints, costs, notes. The same in the gas
// program and inside the DEM ranks; the DEM side's intervals pace the output.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>

#include "coupling/transport/inner_gas.h"
#include "gas_solver/coupling_port.h"
#include "gas_solver/io/progress.h"
#include "gas_solver/io/snapshots.h"

namespace gasgrain {

// For the user, in the place of std::bad_alloc.
constexpr const char* out_of_memory =
    "out of memory: a cell takes 550 to 1100 bytes (docs/gas-speed.md). Take fewer [grid] cells, "
    "or "
    "more ranks on more machines.";

class CoupledGas {
 public:
  // Collective over `comm`, as everything here.
  CoupledGas(const GasInput& input, const GasFiles& files, const Communicator& comm);

  // Does what the DEM program at the other end of the intercommunicator says, until it finishes.
  void serve(MPI_Comm dem);

  // The same piece by piece. The stages before advance() are the port's own.
  [[nodiscard]] CouplingPort& port() { return port_; }
  [[nodiscard]] GasSolver& solver() { return solver_; }
  void meet(const DemHello& dem);
  // When the gas cannot go on, the report says why; the state stays as it was left.
  [[nodiscard]] Report advance();
  // What the interval gave to tell and to write; the DEM side need not wait for it.
  void end_interval();
  // The state that belongs to this DEM step; whole on disk when this returns.
  void write_checkpoint(long dem_step);
  // The same of a run that has gone wrong, under another name; a report of what stood in its way.
  [[nodiscard]] Report write_autopsy(long dem_step);
  // Prints the table of costs; returns the costs as a JSON object (rank 0's; empty elsewhere).
  std::string finish();

 private:
  void tell(MPI_Comm dem, const Report& report);
  // Multiples of [output] every that have been reached.
  [[nodiscard]] long snapshots_due() const;

  GasSolver solver_;
  CouplingPort port_;
  std::string out_;
  bool restarted_;
  double output_every_;  // [s], 0: no snapshots
  std::unique_ptr<Snapshots> snapshots_;
  long written_ = 0;  // the multiple of the last snapshot
  SubstepNote note_;
  GasReport done_;  // of the last interval
  std::size_t cost_output_;
};

}  // namespace gasgrain
