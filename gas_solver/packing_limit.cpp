#include "gas_solver/packing_limit.h"

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

constexpr int neighbours = 6;

// Above the limit by no more than round-off is at the limit.
constexpr double slack = 1e-12;

bool in_domain(const Domain& domain, Int3 cell, int axis, int direction) {
  const int next = cell[axis] + direction;
  return domain.grid().periodic[axis] || (next >= 0 && next < domain.grid().cells[axis]);
}

}  // namespace

long move_solids_above_limit(const Domain& domain, Halo& halo, Array3<double>& solids) {
  Array3<double> share(domain.box());  // what a cell gives to each of its neighbours
  long moved = 0;
  for (int pass = 0; pass < packing_passes; ++pass) {
    long above = 0;
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const double excess = solids(i, j, k) - solids_limit;
      share(i, j, k) = excess > slack ? excess / neighbours : 0.0;
      if (excess > slack) ++above;
    });
    if (pass == 0) moved = above;
    if (domain.comm().sum(above) == 0) return moved;
    halo.exchange({&share});
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      double change = 0.0;
      for (int axis = 0; axis < 3; ++axis)
        for (const int direction : {-1, 1}) {
          if (!in_domain(domain, {i, j, k}, axis, direction)) continue;
          Int3 next{i, j, k};
          next[axis] += direction;
          change += share(next[0], next[1], next[2]) - share(i, j, k);
        }
      solids(i, j, k) += change;
    });
  }
  fail(
      "the particles do not fit: cells still hold more than {} of solids after {} passes of moving "
      "the excess to neighbours. Too many particles overlap: raise the stiffness or shorten the "
      "DEM "
      "step.",
      solids_limit, packing_passes);
}

}  // namespace gasgrain
