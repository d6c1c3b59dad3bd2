// Keeps what a step of time needs of its beginning, and makes what Crank-Nicolson needs of its
// middle. Implicit Euler with a projection needs no more than eps (and the density of an ideal
// gas).
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class TimeLevels {
 public:
  TimeLevels(const GasInput& input, const IndexBox& box, GasState& state);

  // A step of length `step` [s] begins, in which eps goes the share `share` of its way to `to`.
  // Crank-Nicolson extrapolates its convecting fluxes from the last step's; the first takes those
  // of its beginning.
  void begin(GasState& state, double step, const Array3<double>& to, double share);
  // A further outer iteration: the convecting fluxes are the mean of beginning and iterate.
  void iterate(GasState& state) const;

  // Velocity at the step's beginning; where no copy is kept, the state's, which still is it.
  [[nodiscard]] const CellVector& velocity_before(const GasState& state) const {
    return keeps_velocity_ ? velocity_before_ : state.velocity;
  }

  double last_step = 0;  // [s]; 0: none yet

 private:
  bool middle_;
  bool keeps_velocity_;
  CellVector velocity_before_;
};

}  // namespace gasgrain
