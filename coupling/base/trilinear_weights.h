// Trilinear weights of a point among the eight cells whose centres surround it:
//
//   w = product over the axes of (1 - |x - x_c| / h), x_c the cell's centre, h its size
//
// Input: position [m]. Output: dimensionless, sum 1, continuous in the position. Within half a cell
// of a wall the share of the cells beyond it goes to the boundary cell, so that an even filling is
// even in all cells.
#pragma once

#include "coupling/base/axis_weights.h"
#include "coupling/base/tile_frame.h"

namespace gasgrain {

[[gnu::always_inline]] inline std::array<AxisWeights, 3> trilinear_axes(const TileFrame& frame,
                                                                        const Vec3& x) {
  std::array<AxisWeights, 3> axes;
  for (int d = 0; d < 3; ++d) {
    const double s = frame.in_cells(x[d], d) - 0.5;
    const double below = std::floor(s);
    axes[d].add(frame.cell(below, d), 1.0 - (s - below));
    axes[d].add(frame.cell(below + 1.0, d), s - below);
  }
  return axes;
}

}  // namespace gasgrain
