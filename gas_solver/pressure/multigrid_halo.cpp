#include "gas_solver/pressure/multigrid_halo.h"

namespace gasgrain {
namespace {

// The layer at place `at` along an axis.
IndexBox layer(const Array3<float>& field, int axis, int at) {
  IndexBox box = field.box();
  box.lo[axis] = at;
  box.hi[axis] = at + 1;
  return box;
}

void copy_layer(Array3<float>& field, int axis, int from, int to) {
  const std::ptrdiff_t step = (from - to) * field.stride(axis);
  for_each_cell(layer(field, axis, to), [&](int i, int j, int k) {
    const auto o = field.offset(i, j, k);
    field[o] = field[o + step];
  });
}

}  // namespace

void MultigridHalo::exchange(const MultigridGrid& grid, Array3<float>& field) {
  for (int axis = 0; axis < 3; ++axis) exchange(grid, field, axis);
}

void MultigridHalo::exchange(const MultigridGrid& grid, Array3<float>& field, int axis) {
  const IndexBox& own = grid.own;
  if (!splits(grid, axis)) {
    if (!grid.periodic[axis]) return;
    copy_layer(field, axis, own.hi[axis] - 1, own.lo[axis] - 1);
    copy_layer(field, axis, own.lo[axis], own.hi[axis]);
    return;
  }
  for (const int direction : {-1, 1}) {
    const int to = domain_.neighbour(axis, direction);
    const int from = domain_.neighbour(axis, -direction);
    const bool down = direction < 0;
    const IndexBox sent = layer(field, axis, down ? own.lo[axis] : own.hi[axis] - 1);
    const IndexBox received = layer(field, axis, down ? own.hi[axis] : own.lo[axis] - 1);
    sent_.clear();
    if (to != MPI_PROC_NULL)
      for_each_cell(sent, [&](int i, int j, int k) { sent_.push_back(field(i, j, k)); });
    received_.resize(from == MPI_PROC_NULL ? 0 : received.size());
    MPI_Sendrecv(sent_.data(), static_cast<int>(sent_.size()), MPI_FLOAT, to, direction + 1,
                 received_.data(), static_cast<int>(received_.size()), MPI_FLOAT, from,
                 direction + 1, domain_.comm().handle(), MPI_STATUS_IGNORE);
    if (from == MPI_PROC_NULL) continue;
    const float* value = received_.data();
    for_each_cell(received, [&](int i, int j, int k) { field(i, j, k) = *value++; });
  }
}

void MultigridHalo::clear(const MultigridGrid& grid, Array3<float>& field) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!joins(grid, axis)) continue;
    for (const int at : {grid.own.lo[axis] - 1, grid.own.hi[axis]})
      for_each_cell(layer(field, axis, at), [&](int i, int j, int k) { field(i, j, k) = 0; });
  }
}

void MultigridHalo::gather(const MultigridGrid& shared, const Array3<float>& from,
                           Array3<float>& whole, int faces_of_axis) {
  const auto part = [&](IndexBox box) {
    if (faces_of_axis >= 0) ++box.hi[faces_of_axis];
    return box;
  };
  std::vector<int> counts;
  std::vector<int> starts;
  int total = 0;
  for (const IndexBox& box : shared.boxes) {
    starts.push_back(total);
    counts.push_back(static_cast<int>(part(box).size()));
    total += counts.back();
  }
  sent_.clear();
  for_each_cell(part(shared.own), [&](int i, int j, int k) { sent_.push_back(from(i, j, k)); });
  received_.resize(total);
  MPI_Allgatherv(sent_.data(), static_cast<int>(sent_.size()), MPI_FLOAT, received_.data(),
                 counts.data(), starts.data(), MPI_FLOAT, domain_.comm().handle());
  const float* value = received_.data();
  for (const IndexBox& box : shared.boxes)
    for_each_cell(part(box), [&](int i, int j, int k) { whole(i, j, k) = *value++; });
}

}  // namespace gasgrain
