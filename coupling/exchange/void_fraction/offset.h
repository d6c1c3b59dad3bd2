// Offset method: the particle-centre method, averaged over displacements of grid and particles
// against each other by -r to +r along each axis.
//
//   w = product over the axes of (length of [x - r, x + r] within the cell) / 2r
//
// which is to spread the particle evenly over the cube that encloses it.
//
// Source: F. Alobaid, thesis, TU Darmstadt (2013), section 7.1 and figure 7.1(c), after Goetz
//   (2006).
// Inputs: position [m], radius r [m]. Output: dimensionless weights, sum 1.
// Assumptions: none on the size of cells. The weights are continuous in position, hence so is the
//   void fraction in time. The enclosing cubes of neighbours overlap, though the spheres do not.
// Deviations: the thesis averages over the displacements -r, 0 and +r, 27 in all; a third of a
//   particle then jumps when one of its displaced centres crosses a face, and beyond r = h the
//   points leave out cells. Here the mean is over ALL displacements between -r and r. It has the
//   variance d^2 / 12 along an axis rather than d^2 / 6, and the sphere itself has d^2 / 20.
//   The thesis moves the grid and does not speak of walls; here the particle is moved, and what
//   comes to lie beyond a wall counts for the cell at the wall.
#pragma once

#include <string_view>

#include "coupling/base/axis_weights.h"
#include "coupling/base/tile_frame.h"

namespace gasgrain {

struct VoidFractionOffset {
  static constexpr std::string_view name = "offset";
  static constexpr double greatest_jump = 0.0;

  static int reach(const BoxGrid& grid, int axis, double radius) {
    return static_cast<int>(std::ceil(radius / grid.spacing()[axis]));
  }

  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double radius, F&& f) {
    Vec3 s;
    Vec3 r;
    for (int d = 0; d < 3; ++d) {
      s[d] = frame.in_cells(x[d], d);
      r[d] = frame.length_in_cells(radius, d);
    }
    if (r.maxCoeff() <= 1.0)
      give_intervals<AxisWeights>(frame, s, r, f);
    else
      give_intervals<ManyAxisWeights>(frame, s, r, f);
  }

 private:
  template <class Weights, class F>
  static void give_intervals(const TileFrame& frame, const Vec3& s, const Vec3& r, F& f) {
    std::array<Weights, 3> axes;
    for (int d = 0; d < 3; ++d) {
      double from = s[d] - r[d];
      const double end = s[d] + r[d];
      const int last = frame.cell(end, d);
      int cell = frame.cell(from, d);
      if (cell == last) {
        axes[d].add(cell, 1.0);
        continue;
      }
      const double share = 0.5 / r[d];
      for (; cell < last; ++cell) {
        axes[d].add(cell, (cell + 1 - from) * share);
        from = cell + 1;
      }
      axes[d].add(last, (end - from) * share);
    }
    for_each_product(axes, f);
  }
};

}  // namespace gasgrain
