#include "gas_solver/grid/halo.h"

namespace gasgrain {
namespace {

IndexBox layer(IndexBox box, int axis, int begin, int end) {
  box.lo[axis] = begin;
  box.hi[axis] = end;
  return box;
}

}  // namespace

void Halo::exchange(std::initializer_list<Array3<double>*> fields) {
  for (int axis = 0; axis < 3; ++axis) {
    if (domain_.layout()[axis] > 1)
      swap(fields, axis);
    else if (domain_.grid().periodic[axis])
      for (Array3<double>* field : fields) wrap(*field, axis);
  }
}

void Halo::wrap(Array3<double>& field, int axis) const {
  const int cells = domain_.grid().cells[axis];
  const IndexBox box = field.box();
  const auto copy = [&](const IndexBox& ghosts) {
    for_each_cell(ghosts, [&](int i, int j, int k) {
      Int3 from{i, j, k};
      from[axis] = (from[axis] + ghost_layers * cells) % cells;
      field(i, j, k) = field(from[0], from[1], from[2]);
    });
  };
  copy(layer(box, axis, box.lo[axis], 0));
  copy(layer(box, axis, cells, box.hi[axis]));
}

void Halo::swap(std::initializer_list<Array3<double>*> fields, int axis) {
  const IndexBox own = domain_.own();
  for (const int direction : {-1, 1}) {
    const int to = domain_.neighbour(axis, direction);
    const int from = domain_.neighbour(axis, -direction);
    const int out = direction < 0 ? own.lo[axis] : own.hi[axis] - ghost_layers;
    const int in = direction < 0 ? own.hi[axis] : own.lo[axis] - ghost_layers;
    const IndexBox sent = layer(domain_.box(), axis, out, out + ghost_layers);
    const IndexBox received = layer(domain_.box(), axis, in, in + ghost_layers);
    sent_.clear();
    if (to != MPI_PROC_NULL)
      for (const Array3<double>* field : fields)
        for_each_cell(sent, [&](int i, int j, int k) { sent_.push_back((*field)(i, j, k)); });
    received_.resize(from == MPI_PROC_NULL ? 0 : received.size() * fields.size());
    MPI_Sendrecv(sent_.data(), static_cast<int>(sent_.size()), MPI_DOUBLE, to, direction + 1,
                 received_.data(), static_cast<int>(received_.size()), MPI_DOUBLE, from,
                 direction + 1, domain_.comm().handle(), MPI_STATUS_IGNORE);
    if (from == MPI_PROC_NULL) continue;
    const double* value = received_.data();
    for (Array3<double>* field : fields)
      for_each_cell(received, [&](int i, int j, int k) { (*field)(i, j, k) = *value++; });
  }
}

}  // namespace gasgrain
