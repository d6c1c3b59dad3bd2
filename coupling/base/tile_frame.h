// The part of the grid that a rank of particles writes to and reads from, and how a point finds its
// cell in it.
//
// Cell indices of a tile are UNWRAPPED: along a periodic axis they run below 0 and beyond the last
// cell as far as the stencils do, and the transport wraps them. Along an axis with walls whatever
// would fall outside of the box is folded into the boundary cell, so that no solids are lost.
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/base/box_grid.h"

namespace gasgrain {

struct TileFrame {
  BoxGrid grid;
  IndexBox tile;  // cells of the rank, stencil reach included, unwrapped

  // A coordinate in cells from the lower corner of the box.
  [[nodiscard]] double in_cells(double x, int axis) const {
    return (x - grid.lo[axis]) * grid.cells[axis] / (grid.hi[axis] - grid.lo[axis]);
  }
  // A length in cells along one axis.
  [[nodiscard]] double length_in_cells(double length, int axis) const {
    return length * grid.cells[axis] / (grid.hi[axis] - grid.lo[axis]);
  }
  // The cell of a point given in cells, folded at walls.
  [[nodiscard]] int cell(double s, int axis) const {
    if (!grid.periodic[axis]) s = std::clamp(s, 0.0, grid.cells[axis] - 1.0);
    return static_cast<int>(std::floor(s));
  }
  // True when a point is beyond a wall of the box; its solids then go to the boundary cell.
  [[nodiscard]] bool beyond_walls(const Vec3& x) const {
    for (int d = 0; d < 3; ++d)
      if (!grid.periodic[d] && (x[d] < grid.lo[d] || x[d] > grid.hi[d])) return true;
    return false;
  }
};

}  // namespace gasgrain
