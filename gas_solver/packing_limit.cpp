#include "gas_solver/packing_limit.h"

#include <algorithm>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

// A cell hands a sixth of what it gives to each side.
constexpr int sides_of_a_cell = 6;

// Above the limit by no more than round-off is at the limit; below it a cell that gave may be left
// by this much.
constexpr double slack = 1e-12;
constexpr double slack_below = 1e-9;

// Sweeps for spheres of 2, 5 and 10 cells: 15, 30, 89 at 1.4; 21, 40, 52 at 1.5; 27, 53, 55 at 1.6.
constexpr double over_relaxation = 1.5;

bool in_domain(const Domain& domain, Int3 cell, int axis, int direction) {
  const int next = cell[axis] + direction;
  return domain.grid().periodic[axis] || (next >= 0 && next < domain.grid().cells[axis]);
}

// Of most cells of a bed, which would otherwise cost as much as those that give.
bool nothing_given_around(const Array3<double>& given, int i, int j, int k) {
  const double* at = given.data() + given.offset(i, j, k);
  if (*at != 0.0) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (at[given.stride(axis)] != 0.0 || at[-given.stride(axis)] != 0.0) return false;
  return true;
}

// What a cell loses on balance when every cell has given `given` away.
double net_loss(const Domain& domain, const Array3<double>& given, int i, int j, int k) {
  if (nothing_given_around(given, i, j, k)) return 0.0;
  double loss = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int direction : {-1, 1}) {
      if (!in_domain(domain, {i, j, k}, axis, direction)) continue;
      Int3 next{i, j, k};
      next[axis] += direction;
      loss += given(i, j, k) - given(next[0], next[1], next[2]);
    }
  return loss / sides_of_a_cell;
}

// Neighbours differ in colour, so that no sweep takes back what another cell of it has just done: a
// chequerboard. Round a periodic axis of an odd number of cells that takes a third colour.
bool closes_oddly(const BoxGrid& grid, int axis) {
  return grid.periodic[axis] && grid.cells[axis] > 1 && grid.cells[axis] % 2 == 1;
}

int colours_of(const BoxGrid& grid) {
  return closes_oddly(grid, 0) || closes_oddly(grid, 1) || closes_oddly(grid, 2) ? 3 : 2;
}

int colour_of(const BoxGrid& grid, int colours, const Int3& cell) {
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += closes_oddly(grid, axis) && cell[axis] == grid.cells[axis] - 1 ? 2 : cell[axis] & 1;
  return sum % colours;
}

int open_sides(const Domain& domain, int i, int j, int k) {
  int open = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int direction : {-1, 1}) open += in_domain(domain, {i, j, k}, axis, direction);
  return open;
}

}  // namespace

long move_solids_above_limit(const Domain& domain, Halo& halo, Array3<double>& solids) {
  long above = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    if (solids(i, j, k) - solids_limit > slack) ++above;
  });
  if (domain.comm().sum(above) == 0) return 0;

  const int colours = colours_of(domain.grid());
  const Array3<double> before = solids;
  Array3<double> given(domain.box());
  for (int sweep = 0; sweep < packing_sweeps; ++sweep) {
    for (int colour = 0; colour < colours; ++colour) {
      for_each_cell(domain.own(), [&](int i, int j, int k) {
        if (colour_of(domain.grid(), colours, {i, j, k}) != colour) return;
        const double excess = before(i, j, k) - net_loss(domain, given, i, j, k) - solids_limit;
        double& own = given(i, j, k);
        if (excess <= 0.0 && own == 0.0) return;
        const int open = open_sides(domain, i, j, k);
        if (open > 0) own = std::max(0.0, own + over_relaxation * sides_of_a_cell / open * excess);
      });
      halo.exchange({&given});
    }
    long unsettled = 0;
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      solids(i, j, k) = before(i, j, k) - net_loss(domain, given, i, j, k);
      const double excess = solids(i, j, k) - solids_limit;
      if (excess > slack || (given(i, j, k) > 0.0 && excess < -slack_below)) ++unsettled;
    });
    if (domain.comm().sum(unsettled) == 0) return above;
  }
  fail(
      "the particles do not fit: cells still hold more than {} of solids after {} sweeps of moving "
      "the excess to neighbours. Too many particles overlap: raise the stiffness or shorten the "
      "DEM step.",
      solids_limit, packing_sweeps);
}

}  // namespace gasgrain
