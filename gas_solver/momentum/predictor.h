// Predicts the velocity at the end of a step from the pressure at hand: solves the momentum system
// of each component by Gauss-Seidel sweeps, forth and back through the grid. An upwind matrix is
// nearly triangular along the flow, whose direction one of the two sweeps meets: a few pairs do
// even at Courant numbers of tens.
//
// The explicit parts (what a scheme adds to upwind, stress across components) come from the
// velocity at hand first; further passes repeat the prediction with what the last pass found.
// Crank-Nicolson takes them at the middle of the step, for which it needs a second pass to be of
// second order, and a third to damp what the second leaves at Courant numbers about 1.
#pragma once

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/momentum/assembly.h"
#include "gas_solver/momentum/finish_rows.h"

namespace gasgrain {

struct MomentumReport {
  int not_converged = 0;  // components that used all sweeps
};

class Predictor {
 public:
  Predictor(const Domain& domain, const GasInput& input, Halo& halo);

  // Replaces state.velocity, the guess. Collective.
  MomentumReport predict(GasState& state, const MomentumStep& step);

  // See RowFinish.
  [[nodiscard]] const CellVector& mobility() const { return finish_.mobility(); }

 private:
  struct Change {
    double change = 0;   // sum of squares of what a sweep changed
    double squares = 0;  // sum of squares of the velocity
  };
  void pass(GasState& state, const MomentumStep& step, const CellVector& lagged,
            MomentumReport& report);
  const CellVector& mean_in_time(const CellVector& before, const CellVector& after);
  Change sweep(int component, bool forth);

  const Domain& domain_;
  Walls walls_;
  double tolerance_;
  double theta_;
  int passes_;
  Halo& halo_;
  MomentumAssembly assembly_;
  RowFinish finish_;
  Array3<MomentumRow> rows_;
  CellVector solution_;
  CellVector lagged_;  // where it is not the velocity at hand
};

}  // namespace gasgrain
