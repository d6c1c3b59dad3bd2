// Solves the pressure equation by conjugate gradients preconditioned with hypre's PFMG, a
// semicoarsening multigrid for cell-by-cell varying coefficients. The unknown is a pressure
// increment, for which 0 is the guess that holds what the last steps found.
//
// The multigrid is built anew only when its last build serves no more: a build costs about as much
// as one to two iterations, so that one of an earlier step is kept while the iterations grow by
// less.
#pragma once

#include <HYPRE_struct_ls.h>

#include <vector>

#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

class HyprePfmg {
 public:
  explicit HyprePfmg(const Domain& domain);
  ~HyprePfmg();
  HyprePfmg(const HyprePfmg&) = delete;
  HyprePfmg& operator=(const HyprePfmg&) = delete;

  // Until the 2-norm of the residual is below `tolerance`, from 0. Returns the iterations.
  int solve(PressureSystem& system, double tolerance);
  // The next solve builds the multigrid anew.
  void forget() { built_ = false; }

 private:
  void set_matrix(const PressureSystem& system);
  void build();
  int iterate(PressureSystem& system, double tolerance, int max_iterations);

  const Domain& domain_;
  HYPRE_StructGrid grid_ = nullptr;
  HYPRE_StructStencil stencil_ = nullptr;
  HYPRE_StructMatrix matrix_ = nullptr;
  HYPRE_StructVector source_ = nullptr;
  HYPRE_StructVector solution_ = nullptr;
  HYPRE_StructSolver multigrid_ = nullptr;
  HYPRE_StructSolver gradients_ = nullptr;
  bool built_ = false;
  int iterations_after_build_ = 0;
  std::vector<double> values_;
};

}  // namespace gasgrain
