// Trilinear (volume) weighting: the particle is shared among the eight cells whose centres surround
// its centre; the nearer the cell's centre, the greater its share.
//
//   w = product over the axes of (1 - |x - x_c| / h), x_c the cell's centre, h its size
//
// Source: the area weighting of B.P.B. Hoomans et al., Powder Technol. 116 (2001) 166, below eq 34,
//   in three dimensions.
// Inputs: position [m]. Output: dimensionless weights, sum 1; the radius plays no part.
// Assumptions: none on the particle's size; solids are smeared over the size of a cell. The weights
//   are continuous in position, hence so is the void fraction in time.
// Deviation: within half a cell of a wall the share of the cells beyond it goes to the boundary
// cell.
#pragma once

#include <string_view>

#include "coupling/base/trilinear_weights.h"

namespace gasgrain {

struct VoidFractionTrilinear {
  static constexpr std::string_view name = "trilinear";
  static constexpr double greatest_jump = 0.0;

  static int reach(const BoxGrid& /*grid*/, int /*axis*/, double /*radius*/) { return 1; }

  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double /*radius*/, F&& f) {
    for_each_product(trilinear_axes(frame, x), f);
  }
};

}  // namespace gasgrain
