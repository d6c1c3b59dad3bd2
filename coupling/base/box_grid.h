// The uniform Cartesian grid that gas and particles share, and the boxes of cells cut from it.
//
// Cells are numbered from 0 in each direction; cell (i, j, k) spans lo + (i, j, k) h to
// lo + (i+1, j+1, k+1) h. Every index in the program is GLOBAL: a rank holds an IndexBox of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "coupling/base/vec3.h"

namespace gasgrain {

// Cells lo <= (i, j, k) < hi.
struct IndexBox {
  Int3 lo{0, 0, 0};
  Int3 hi{0, 0, 0};

  [[nodiscard]] int extent(int axis) const { return std::max(0, hi[axis] - lo[axis]); }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(extent(0)) * extent(1) * extent(2);
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] bool contains(int i, int j, int k) const {
    return i >= lo[0] && i < hi[0] && j >= lo[1] && j < hi[1] && k >= lo[2] && k < hi[2];
  }
  [[nodiscard]] IndexBox grown(int width) const {
    return {{lo[0] - width, lo[1] - width, lo[2] - width},
            {hi[0] + width, hi[1] + width, hi[2] + width}};
  }
  bool operator==(const IndexBox& o) const { return lo == o.lo && hi == o.hi; }
  bool operator!=(const IndexBox& o) const { return !(*this == o); }
};

inline IndexBox intersection(const IndexBox& a, const IndexBox& b) {
  IndexBox c;
  for (int d = 0; d < 3; ++d) {
    c.lo[d] = std::max(a.lo[d], b.lo[d]);
    c.hi[d] = std::max(c.lo[d], std::min(a.hi[d], b.hi[d]));
  }
  return c;
}

struct BoxGrid {
  Vec3 lo = Vec3::Zero();                             // lower corner [m]
  Vec3 hi = Vec3::Ones();                             // upper corner [m]
  Int3 cells{1, 1, 1};                                // cells per direction
  std::array<bool, 3> periodic{false, false, false};  // per direction

  [[nodiscard]] Vec3 spacing() const {
    return (hi - lo).cwiseQuotient(Vec3(cells[0], cells[1], cells[2]));
  }
  [[nodiscard]] double cell_volume() const { return spacing().prod(); }
  [[nodiscard]] IndexBox all() const { return {{0, 0, 0}, cells}; }
  // Index of the cell that holds coordinate x along one axis; outside of the grid the index goes
  // on.
  [[nodiscard]] int cell_of(double x, int axis) const {
    return static_cast<int>(std::floor((x - lo[axis]) * cells[axis] / (hi[axis] - lo[axis])));
  }
};

}  // namespace gasgrain
