#include "gas_solver/grid/domain.h"

#include "coupling/base/decomposition.h"

namespace gasgrain {

Domain::Domain(const BoxGrid& grid, const Communicator& comm)
    : grid_(grid), comm_(comm), layout_(rank_layout(grid, comm.size())) {
  own_ = decompose(grid, comm.size())[comm.rank()];
  place_ = {comm.rank() % layout_[0], comm.rank() / layout_[0] % layout_[1],
            comm.rank() / layout_[0] / layout_[1]};
}

bool Domain::touches(int side) const {
  const int axis = axis_of(side);
  if (grid_.periodic[axis]) return false;
  return is_high(side) ? own_.hi[axis] == grid_.cells[axis] : own_.lo[axis] == 0;
}

int Domain::neighbour(int axis, int direction) const {
  Int3 at = place_;
  at[axis] += direction;
  if (at[axis] < 0 || at[axis] >= layout_[axis]) {
    if (!grid_.periodic[axis]) return MPI_PROC_NULL;
    at[axis] = (at[axis] + layout_[axis]) % layout_[axis];
  }
  return at[0] + layout_[0] * (at[1] + layout_[1] * at[2]);
}

IndexBox Domain::faces(int axis) const {
  IndexBox faces = own_;
  if (touches(side_of(axis, true))) ++faces.hi[axis];
  return faces;
}

IndexBox Domain::inner_faces(int axis) const {
  IndexBox faces = own_;
  if (touches(side_of(axis, false))) ++faces.lo[axis];
  return faces;
}

IndexBox Domain::side_faces(int side) const {
  if (!touches(side)) return {};
  const int axis = axis_of(side);
  IndexBox faces = own_;
  faces.lo[axis] = is_high(side) ? own_.hi[axis] : own_.lo[axis];
  faces.hi[axis] = faces.lo[axis] + 1;
  return faces;
}

}  // namespace gasgrain
