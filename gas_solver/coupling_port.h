// The gas's side of a coupled step: takes what the DEM ranks deposit, advances the gas, lends its
// fields. The stages of an interval, in this order:
//   begin, route (when the DEM ranks' tiles are new), take_solids, advance
// Where the DEM ranks are, in another program or on these same ranks, only the transport knows.
#pragma once

#include <string>
#include <vector>

#include "coupling/exchange/field_store.h"
#include "coupling/transport/protocol.h"
#include "coupling/transport/route.h"
#include "gas_solver/gas_step.h"

namespace gasgrain {

class CouplingPort {
 public:
  // `input_file`: of the solver, for messages.
  CouplingPort(GasSolver& solver, const GasInput& input, const std::string& input_file);

  [[nodiscard]] GasHello hello() const;
  // The fields that the DEM side asks for, and no others, are computed and lent from here on.
  void meet(const DemHello& dem);

  // Throws Error when the interval does not begin where the gas is.
  void begin(const Command& command);
  // The way of the fields between this rank's cells and the tiles of the DEM ranks.
  void route(const std::vector<IndexBox>& tiles, MPI_Comm channel, Sends sends);
  void take_solids();
  // Takes the drag, advances over the interval, lends the means.
  GasReport advance();
  // After an advance() that threw: lends what there is, so that the DEM ranks do not wait for it.
  void lend_anyway() { send_lent(lent_.without(lent_early)); }
  [[nodiscard]] Report report_of(const GasReport& done) const;
  // Waits until the DEM ranks have what was lent.
  void finish_sends() { transport_.finish_sends(); }

  // Tasks of the cost ledger: time that is the DEM side's, and that of messages.
  [[nodiscard]] std::size_t cost_wait() const { return cost_wait_; }
  [[nodiscard]] std::size_t cost_transport() const { return cost_transport_; }

 private:
  [[nodiscard]] Array3<double> solids_in_cells();
  void take_drag();
  void send_lent(FieldSet fields);

  GasSolver& solver_;
  Communicator local_;
  double plane_of_spheres_;  // [m], 0: not one
  GasHello hello_;           // but for the time
  FieldSet lent_;
  FieldSet taken_;
  Halo halo_;
  RouteTransport transport_;
  Command command_;  // of the interval at work
  long moved_cells_ = 0;

  FieldStore fields_;  // lent and taken, over own()

  std::size_t cost_transport_;
  std::size_t cost_wait_;
  std::size_t cost_solids_;
  std::size_t cost_fields_;
};

}  // namespace gasgrain
