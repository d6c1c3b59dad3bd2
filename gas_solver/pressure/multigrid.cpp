#include "gas_solver/pressure/multigrid.h"

#include "gas_solver/pressure/multigrid_coarsening.h"
#include "gas_solver/pressure/multigrid_hierarchy.h"
#include "gas_solver/pressure/multigrid_smoother.h"

namespace gasgrain {
namespace {

// The own part of a correction that every rank holds.
void take(const MultigridGrid& whole, MultigridGrid& grid) {
  for_each_cell(grid.own, [&](int i, int j, int k) {
    float& x = grid.solution(i, j, k);
    x = grid.relaxed ? x + whole.solution(i, j, k) : whole.solution(i, j, k);
  });
}

}  // namespace

Multigrid::Multigrid(const Domain& domain)
    : domain_(domain), halo_(domain), grids_(multigrid_hierarchy(domain)) {}

void Multigrid::set(const PressureSystem& system) {
  for (MultigridGrid& grid : grids_)
    if (has_storage(system) && grid.storage.size() == 0)
      grid.storage = Array3<float>(grid.own.grown(1));
  MultigridGrid& finest = grids_.front();
  for (int d = 0; d < 3; ++d) {
    for_each_cell(finest.faces(d), [&](int i, int j, int k) {
      finest.face_coefficient[d](i, j, k) = static_cast<float>(system.face_coefficient[d](i, j, k));
    });
    halo_.exchange(finest, finest.face_coefficient[d]);
  }
  if (has_storage(system)) {
    for_each_cell(finest.own, [&](int i, int j, int k) {
      finest.storage(i, j, k) = static_cast<float>(system.storage(i, j, k));
    });
    halo_.exchange(finest, finest.storage);
  }
  for (std::size_t level = 0; level < grids_.size(); ++level) {
    MultigridGrid& grid = grids_[level];
    if (grid.relaxed) set_diagonal(grid);
    if (level + 1 == grids_.size()) return;
    MultigridGrid& next = grids_[level + 1];
    if (grid.coarsened_along >= 0) {
      coarsen(grid, next, halo_);
      continue;
    }
    for (int d = 0; d < 3; ++d) {
      halo_.gather(grid, grid.face_coefficient[d], next.face_coefficient[d], d);
      halo_.exchange(next, next.face_coefficient[d]);
    }
    if (!has_storage(system)) continue;
    halo_.gather(grid, grid.storage, next.storage);
    halo_.exchange(next, next.storage);
  }
}

double Multigrid::correction(const Array3<double>& residual) {
  return domain_.comm().sum(cycle(0, residual));
}

// Returns this rank's product of source and solution where the grid is relaxed.
template <class T>
double Multigrid::cycle(std::size_t level, const Array3<T>& source) {
  MultigridGrid& grid = grids_[level];
  if (grid.relaxed) relax_from_zero(grid, source, halo_);
  if (level + 1 < grids_.size()) {
    MultigridGrid& next = grids_[level + 1];
    if (grid.coarsened_along < 0)
      halo_.gather(grid, grid.left(), next.source);
    else
      restrict_rest(grid, next, halo_);
    cycle(level + 1, next.source);
    if (grid.coarsened_along < 0)
      take(next, grid);
    else
      correct(grid, next, halo_);
  }
  return grid.relaxed ? relax(grid, source, halo_) : 0.0;
}

void Multigrid::turn(Array3<double>& direction, double share) {
  const IndexBox& own = domain_.own();
  for (int k = own.lo[2]; k < own.hi[2]; ++k)
    for (int j = own.lo[1]; j < own.hi[1]; ++j) {
      double* p = &direction(own.lo[0], j, k);
      const float* z = &grids_.front().solution(own.lo[0], j, k);
#pragma GCC ivdep
      for (int n = 0; n < own.extent(0); ++n) p[n] = z[n] + share * p[n];
    }
}

}  // namespace gasgrain
