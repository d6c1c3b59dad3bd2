#include "gas_solver/pressure/slabs.h"

#include "coupling/base/decomposition.h"

namespace gasgrain {
namespace {

void count(const std::vector<IndexBox>& parts, std::vector<int>& counts, std::vector<int>& starts) {
  int start = 0;
  for (const IndexBox& part : parts) {
    counts.push_back(static_cast<int>(part.size()));
    starts.push_back(start);
    start += counts.back();
  }
}

}  // namespace

Slabs::Slabs(const Domain& domain, int axis, int thickness) : domain_(domain) {
  const Int3& cells = domain.grid().cells;
  const auto plane = plane_axes(axis);
  stride_[plane[0]] = 1;
  stride_[plane[1]] = cells[plane[0]];
  stride_[axis] = static_cast<std::ptrdiff_t>(cells[plane[0]]) * cells[plane[1]];
  const auto slab = [&](int rank) {
    IndexBox box = domain.grid().all();
    box.lo[axis] = std::min(rank * thickness, cells[axis]);
    box.hi[axis] = std::min(box.lo[axis] + thickness, cells[axis]);
    return box;
  };
  const Communicator& comm = domain.comm();
  const IndexBox own_slab = slab(comm.rank());
  origin_ = own_slab.lo[axis] * stride_[axis];
  layers_ = own_slab.extent(axis);
  const std::vector<IndexBox> boxes = decompose(domain.grid(), comm.size());
  for (int rank = 0; rank < comm.size(); ++rank) {
    of_box_.push_back(intersection(domain.own(), slab(rank)));
    of_slab_.push_back(intersection(boxes[rank], own_slab));
  }
  if (comm.size() == 1) return;
  count(of_box_, box_counts_, box_starts_);
  count(of_slab_, slab_counts_, slab_starts_);
  in_boxes_.resize(domain.own().size());
  in_slabs_.resize(own_slab.size());
}

void Slabs::gather(const Array3<double>& cells, double* slab) {
  if (domain_.comm().size() == 1) {
    for_each_cell(domain_.own(),
                  [&](int i, int j, int k) { slab[place(i, j, k)] = cells(i, j, k); });
    return;
  }
  double* out = in_boxes_.data();
  for (const IndexBox& part : of_box_)
    for_each_cell(part, [&](int i, int j, int k) { *out++ = cells(i, j, k); });
  MPI_Alltoallv(in_boxes_.data(), box_counts_.data(), box_starts_.data(), MPI_DOUBLE,
                in_slabs_.data(), slab_counts_.data(), slab_starts_.data(), MPI_DOUBLE,
                domain_.comm().handle());
  const double* in = in_slabs_.data();
  for (const IndexBox& part : of_slab_)
    for_each_cell(part, [&](int i, int j, int k) { slab[place(i, j, k)] = *in++; });
}

void Slabs::scatter(const double* slab, Array3<double>& cells) {
  if (domain_.comm().size() == 1) {
    for_each_cell(domain_.own(),
                  [&](int i, int j, int k) { cells(i, j, k) = slab[place(i, j, k)]; });
    return;
  }
  double* out = in_slabs_.data();
  for (const IndexBox& part : of_slab_)
    for_each_cell(part, [&](int i, int j, int k) { *out++ = slab[place(i, j, k)]; });
  MPI_Alltoallv(in_slabs_.data(), slab_counts_.data(), slab_starts_.data(), MPI_DOUBLE,
                in_boxes_.data(), box_counts_.data(), box_starts_.data(), MPI_DOUBLE,
                domain_.comm().handle());
  const double* in = in_boxes_.data();
  for (const IndexBox& part : of_box_)
    for_each_cell(part, [&](int i, int j, int k) { cells(i, j, k) = *in++; });
}

}  // namespace gasgrain
