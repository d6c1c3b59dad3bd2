// The share of the grid that one gas rank holds, and the numbering of faces and sides.
//
// Face i of component d is the LOW face of cell i along axis d: velocity u[d](i, j, k) lives at
// x_d = lo_d + i h_d. A rank holds the faces of its cells' low sides; where its box ends at a side
// of the domain that is not periodic, it also holds the face of that side.
//
// Every field, of cells and of faces, is an Array3 over the same box(): the own cells and two
// layers around them, so that one offset and one set of strides address all fields.
#pragma once

#include <string_view>
#include <vector>

#include "coupling/base/array3.h"
#include "coupling/base/box_grid.h"
#include "coupling/base/communicator.h"

namespace gasgrain {

inline constexpr int ghost_layers = 2;  // the limiter looks two faces upwind

// The six sides: 2 * axis, + 1 for the high one.
inline constexpr int side_count = 6;
inline constexpr std::array<std::string_view, side_count> side_names{"x_lo", "x_hi", "y_lo",
                                                                     "y_hi", "z_lo", "z_hi"};
constexpr int side_of(int axis, bool high) {
  return 2 * axis + (high ? 1 : 0);
}
constexpr int axis_of(int side) {
  return side / 2;
}
constexpr bool is_high(int side) {
  return side % 2 == 1;
}
// The two axes that lie in a side, in axis order.
constexpr std::array<int, 2> plane_axes(int axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

class Domain {
 public:
  Domain(const BoxGrid& grid, const Communicator& comm);

  [[nodiscard]] const BoxGrid& grid() const { return grid_; }
  [[nodiscard]] const Communicator& comm() const { return comm_; }
  [[nodiscard]] const IndexBox& own() const { return own_; }
  [[nodiscard]] IndexBox box() const { return own_.grown(ghost_layers); }
  [[nodiscard]] const Int3& layout() const { return layout_; }
  [[nodiscard]] const Int3& place() const { return place_; }

  // The own box ends at this side of the domain, and the side is not periodic.
  [[nodiscard]] bool touches(int side) const;
  // Rank next to this one along an axis (-1 or +1); MPI_PROC_NULL where the domain ends.
  [[nodiscard]] int neighbour(int axis, int direction) const;

  // Faces held, those on the sides of the domain included.
  [[nodiscard]] IndexBox faces(int axis) const;
  // Faces held between two cells.
  [[nodiscard]] IndexBox inner_faces(int axis) const;
  // Faces held on one side of the domain; empty when the rank does not touch it.
  [[nodiscard]] IndexBox side_faces(int side) const;

 private:
  BoxGrid grid_;
  Communicator comm_;
  Int3 layout_;
  Int3 place_;
  IndexBox own_;
};

// Offset from a face on a side to the cell inside it, and the same in faces inwards.
inline std::ptrdiff_t inner_cell_offset(int side, std::ptrdiff_t stride) {
  return is_high(side) ? -stride : 0;
}
inline std::ptrdiff_t inward(int side, std::ptrdiff_t stride) {
  return is_high(side) ? -stride : stride;
}

}  // namespace gasgrain
