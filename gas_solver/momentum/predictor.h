// Predicts the velocity at the end of a step from the pressure at its beginning: solves the
// momentum system of each component by Gauss-Seidel sweeps, forth and back through the grid. An
// upwind matrix is nearly triangular along the flow, whose direction one of the two sweeps meets: a
// few pairs do even at Courant numbers of tens.
#pragma once

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/momentum/assembly.h"

namespace gasgrain {

struct MomentumReport {
  int sweeps = 0;         // pairs, all components
  int not_converged = 0;  // components that used all sweeps
};

class Predictor {
 public:
  Predictor(const Domain& domain, const GasInput& input, Halo& halo);

  // Replaces state.velocity. Collective.
  MomentumReport predict(GasState& state, double step, const std::vector<InflowFace>& inflow);

 private:
  struct Change {
    double change = 0;   // sum of squares of what a sweep changed
    double squares = 0;  // sum of squares of the velocity
  };
  Change sweep(int component, bool forth);

  const Domain& domain_;
  Sides sides_;
  double tolerance_;
  Halo& halo_;
  MomentumAssembly assembly_;
  Array3<MomentumRow> rows_;
  std::array<Array3<double>, 3> solution_;
};

}  // namespace gasgrain
