// A geometric multigrid in single precision for coefficients that vary cell by cell: one V cycle is
// a preconditioner, symmetric and positive definite. An iteration passes about half the bytes of
// one with a multigrid in double precision, and memory is what sets the speed on large grids.
//
// A cycle smooths once before and once after the correction by coarser grids
// (multigrid_smoother.h), down to one cell (multigrid_hierarchy.h, multigrid_coarsening.h). A
// second sweep each needs 0.6 of the iterations and the same time.
//
// Of the preconditioner single precision is enough. The iteration itself stays in double precision:
// in single precision, with the residual corrected in double, it stalled at a contrast of 650,
// where the rounding of its direction, 1e-7 times the contrast times the square of the cells along
// an axis, exceeds the residual.
#pragma once

#include "gas_solver/pressure/conjugate_gradients.h"
#include "gas_solver/pressure/multigrid_halo.h"

namespace gasgrain {

class Multigrid : public SplitPreconditioner {
 public:
  explicit Multigrid(const Domain& domain);

  // The matrix to precondition. Collective.
  void set(const PressureSystem& system);

  double correction(const Array3<double>& residual) override;
  void turn(Array3<double>& direction, double share) override;

 private:
  template <class T>
  double cycle(std::size_t level, const Array3<T>& source);

  const Domain& domain_;
  MultigridHalo halo_;
  std::vector<MultigridGrid> grids_;  // from the finest
};

}  // namespace gasgrain
