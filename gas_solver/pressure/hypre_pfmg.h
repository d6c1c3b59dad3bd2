// hypre's PFMG, a semicoarsening multigrid for coefficients that vary cell by cell, as the
// preconditioner of conjugate gradients.
//
// A build of the multigrid costs about as much as 1.6 iterations, so that one of an earlier step is
// kept while it serves nearly as well as it did at first.
//
// Round a periodic axis the multigrid sees the grid cut open: conjugate gradients mend the cut in
// some tens of iterations, while PFMG's own periodic axes do not converge on most lengths
// (hypre 2.26).
//
// Of hypre's options, measured at contrasts 24 to 10000: two relaxations need 0.65 of the
// iterations and the same time. Galerkin coarse grids with Jacobi relaxation need 0.55 of the
// iterations at a contrast of 10000 and 1.0 at 24, and the same time or more, with 110 to 160 bytes
// a cell more.
#pragma once

#include <HYPRE_struct_ls.h>

#include <vector>

#include "gas_solver/pressure/conjugate_gradients.h"

namespace gasgrain {

class HyprePfmg {
 public:
  explicit HyprePfmg(const Domain& domain);
  ~HyprePfmg();
  HyprePfmg(const HyprePfmg&) = delete;
  HyprePfmg& operator=(const HyprePfmg&) = delete;

  // Solves what `gradients` has begun; returns the iterations, at most `limit`. Collective.
  int solve(PressureSystem& system, ConjugateGradients& gradients, int limit);
  // The same with the multigrid as the last solve left it, on the same system.
  int go_on(PressureSystem& system, ConjugateGradients& gradients, int limit);
  // The next solve builds the multigrid anew.
  void forget();

 private:
  void set_matrix(const PressureSystem& system);
  void build();
  void precondition(const Array3<double>& residual, Array3<double>& correction);

  const Domain& domain_;
  HYPRE_StructGrid grid_ = nullptr;
  HYPRE_StructStencil stencil_ = nullptr;
  HYPRE_StructMatrix matrix_ = nullptr;
  HYPRE_StructVector source_ = nullptr;
  HYPRE_StructVector solution_ = nullptr;
  HYPRE_StructSolver multigrid_ = nullptr;
  std::vector<double> plane_;  // matrix entries on their way

  double pace_ = 0;   // iterations a decade right after the build; 0: no build to keep
  int kept_for_ = 0;  // solves
  int solves_without_keeping_ = 0;  // to come
};

}  // namespace gasgrain
