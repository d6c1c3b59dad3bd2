// Kernel method: solids are spread about the particle's centre with a bell of a width that is fixed
// in particle diameters, whatever the size of the cells.
//
//   w = S w_trilinear,   S = product over the axes of exp(tau L)
//
// L is the exchange of heat between neighbouring cells (heat_kernel.h), no flux through walls. The
// bell is that of WIDTH b = `width` d, d the diameter: exp(-|x - x_p|^2 / b^2), of variance b^2 / 2
// along each axis. Trilinear weighting brings h^2 / 6 of it, and the exchange the rest:
//
//   tau = max(0, b^2 / (2 h^2) - 1/6)          [cells squared], along each axis with its own h
//
// Sources: the kernel and its bandwidth b as in R. Sun, H. Xiao, Int. J. Multiphase Flow 77 (2015)
//   142, who use b = 6 d; to smooth by diffusion, walls included, is theirs as well. The weighting
//   is trilinear.h.
// Inputs: position [m], diameter [m], the greatest in the bed at the first coupling (one width for
//   all sizes: a small grain is spread as wide as a great one). Output: dimensionless weights,
//   positive, sum 1.
// Assumptions: averages over a few diameters mean something, that is, what is looked for in the bed
//   is wider than b.
// Valid range: any size of cells; from h = sqrt(3) b on S is nothing and the method is trilinear.
//   The weights are continuous in position.
// Default width 2: a random packing of 0.58 then has a spread of eps of 0.013, as cells of 5 d
// have,
//   and what is wider than 3.3 d, the bell's width at half its height, is kept (docs/exchange.md).
// Walls: what would go through a wall comes back, mirrored, as often as there are walls in reach.
// Deviation: Sun and Xiao step the diffusion equation in time, with an error of the step, over the
//   whole bed. Here its solution on the cells is applied.
//
// Why no transform (FFTW): between walls S is a cosine transform, a factor, and the transform back,
// in all a distributed transform of every field at every coupling. But S is short: a rank of
// particles needs the cells within reach of its own only, which its tile is grown by, so that no
// rank talks to another; and three products of a banded matrix with a tile cost about as much as
// the deposit of the particles.
#pragma once

#include <string_view>

#include "coupling/exchange/separable_spread.h"
#include "coupling/exchange/void_fraction/heat_kernel.h"
#include "coupling/exchange/void_fraction/trilinear.h"

namespace gasgrain {

struct VoidFractionKernel {
  static constexpr std::string_view name = "kernel";
  static constexpr double greatest_jump = 0.0;
  static constexpr double default_width = 2.0;

  double width = default_width;  // b in diameters
  double diameter = 0.0;         // [m]; 0: twice the radius asked about

  [[nodiscard]] double tau(const BoxGrid& grid, int axis, double radius) const {
    const double b = width * (diameter > 0.0 ? diameter : 2.0 * radius) / grid.spacing()[axis];
    return std::max(0.0, 0.5 * b * b - 1.0 / 6.0);
  }

  [[nodiscard]] int reach(const BoxGrid& grid, int axis, double radius) const {
    const auto cells = static_cast<int>(heat_kernel(tau(grid, axis, radius)).size()) - 1;
    return 1 + (grid.periodic[axis] ? std::min(cells, grid.cells[axis] / 2) : cells);
  }

  // The points that are spread are the cells themselves.
  [[nodiscard]] static IndexRange points(const BoxGrid& /*grid*/, int /*axis*/, double /*radius*/,
                                         IndexRange cells) {
    return cells;
  }
  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double radius, F&& f) {
    VoidFractionTrilinear::for_each_weight(frame, x, radius, f);
  }

  [[nodiscard]] AxisSpread spread(const BoxGrid& grid, int axis, double radius,
                                  IndexRange points) const {
    const std::vector<double> u = heat_kernel(tau(grid, axis, radius));
    const int reached = reach(grid, axis, radius) - 1;
    const int n = grid.cells[axis];
    IndexRange cells{points.lo - reached, points.hi + reached};
    if (grid.periodic[axis])
      cells.hi = std::min(cells.hi, cells.lo + n);  // the rest are the same cells again
    else
      cells = {std::max(0, cells.lo), std::min(n, cells.hi)};
    AxisSpread spread(points, cells);
    for (int point = points.lo; point < points.hi; ++point)
      for (int m = 1 - static_cast<int>(u.size()); m < static_cast<int>(u.size()); ++m) {
        const int cell = grid.periodic[axis] ? cells.lo + modulo(point + m - cells.lo, n)
                                             : mirrored(point + m, n);
        spread.add(cell, point, u[std::abs(m)]);
      }
    return spread;
  }

 private:
  static int modulo(int a, int n) { return ((a % n) + n) % n; }
  static int mirrored(int cell, int n) {
    const int folded = modulo(cell, 2 * n);
    return folded < n ? folded : 2 * n - 1 - folded;
  }
};

}  // namespace gasgrain
