// The gas program's side of a coupled run: takes what the DEM ranks deposit, advances the gas,
// lends its fields. The one place where the gas solver sees the coupling.
#pragma once

#include <mpi.h>

#include <functional>
#include <string>

#include "coupling/exchange/field_store.h"
#include "coupling/transport/protocol.h"
#include "coupling/transport/route.h"
#include "gas_solver/gas_step.h"

namespace gasgrain {

class CouplingPort {
 public:
  // Meets the DEM program. `input_file`: of the solver, for messages; `out`: folder of the results.
  CouplingPort(GasSolver& solver, const GasInput& input, MPI_Comm partner,
               const std::string& input_file, const std::string& out);

  // Serves the DEM program until it finishes; `after_interval` is called when an interval is done
  // and the particles have their fields. Collective over both programs.
  void serve(const std::function<void(const GasReport&)>& after_interval);

 private:
  GasReport couple(const Command& command);
  void take_solids(bool fresh);
  void take_drag();
  void send_lent(FieldSet fields);
  [[nodiscard]] Report report_of(const GasReport& done) const;

  GasSolver& solver_;
  Communicator local_;
  MPI_Comm partner_;
  std::string out_;
  double plane_of_spheres_;  // [m], 0: not one
  FieldSet lent_;
  FieldSet taken_;
  Halo halo_;
  RouteTransport transport_;
  long moved_cells_ = 0;

  FieldStore fields_;  // lent and taken, over own()

  std::size_t cost_transport_;
  std::size_t cost_wait_;
};

}  // namespace gasgrain
