// Offset method: the particle-centre method, averaged over 27 displacements of grid and particles
// against each other by (-r, 0, +r) along each axis.
//
//   w(i, j, k) = (number of displacements whose displaced centre lies in the cell) / 27
//
// The mean is separable: along each axis the points x - r, x, x + r carry a third each.
//
// Source: F. Alobaid, thesis, TU Darmstadt (2013), section 7.1 and figure 7.1(c), after Goetz
// (2006). Inputs: position [m], radius r [m]. Output: dimensionless weights, sum 1. Assumptions: r
// is not greater than a cell; beyond that the 27 points leave out the cells between
//   them. The weights are a step function of position: one face crossed by one of the points moves
//   a third of the particle.
// Deviation: the thesis moves the grid and does not speak of walls; here the particle is moved, and
// a
//   displaced centre beyond a wall counts for the cell at the wall.
#pragma once

#include <string_view>

#include "coupling/exchange/void_fraction/axis_weights.h"
#include "coupling/exchange/void_fraction/tile_frame.h"

namespace gasgrain {

struct VoidFractionOffset {
  static constexpr std::string_view name = "offset";
  static constexpr double greatest_jump = 1.0 / 3.0;

  static int reach(double radius, double h) { return static_cast<int>(std::ceil(radius / h)); }

  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double radius, F&& f) {
    std::array<AxisWeights, 3> axes;
    for (int d = 0; d < 3; ++d) {
      const double s = frame.in_cells(x[d], d);
      const double r = frame.length_in_cells(radius, d);
      for (const double point : {s - r, s, s + r}) axes[d].add(frame.cell(point, d), 1.0 / 3.0);
    }
    for_each_product(axes, f);
  }
};

}  // namespace gasgrain
