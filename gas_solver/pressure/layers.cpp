#include "gas_solver/pressure/layers.h"

#include <cmath>
#include <limits>

namespace gasgrain {
namespace {

// Coefficients that differ by less than this share count as equal: round-off of their means.
constexpr double equal_within = 1e-13;

bool equal(double a, double b) {
  return std::abs(a - b) <= equal_within * std::abs(b);
}

// Both sides of the axis give the normal velocity, or are one.
bool transformable(const PressureSystem& system, int axis) {
  const BoundaryKind& lo = *system.sides[side_of(axis, false)];
  const BoundaryKind& hi = *system.sides[side_of(axis, true)];
  return lo.periodic || (lo.normal_velocity_given && hi.normal_velocity_given);
}

// The fields that a system of layers consists of: field(values, box, first), the last being the
// place in a list of all layers' values, field after field, where that of layer 0 belongs. Faces on
// the sides of the plane are left out: nothing flows along the plane there.
template <class F>
void for_each_field(const Domain& domain, const PressureSystem& system, int axis, F&& field) {
  const int cells = domain.grid().cells[axis];
  const auto plane = plane_axes(axis);
  field(system.face_coefficient[axis], domain.faces(axis), 0);
  field(system.face_coefficient[plane[0]], domain.inner_faces(plane[0]), cells + 1);
  field(system.face_coefficient[plane[1]], domain.inner_faces(plane[1]), 2 * cells + 1);
  if (has_storage(system)) field(system.storage, domain.own(), 3 * cells + 1);
}

int value_count(const Domain& domain, int axis) {
  return 4 * domain.grid().cells[axis] + 1;
}

bool layered_on_this_rank(const Domain& domain, const PressureSystem& system, int axis) {
  bool layered = true;
  for_each_field(domain, system, axis, [&](const Array3<double>& c, const IndexBox& box, int) {
    for (int k = box.lo[2]; k < box.hi[2] && layered; ++k)
      for (int j = box.lo[1]; j < box.hi[1] && layered; ++j)
        for (int i = box.lo[0]; i < box.hi[0] && layered; ++i) {
          Int3 first = box.lo;
          first[axis] = Int3{i, j, k}[axis];
          layered = equal(c(i, j, k), c(first[0], first[1], first[2]));
        }
  });
  return layered;
}

// Given that each rank's are layers: the ranks' layers are the same.
bool layers_agree(const Domain& domain, const PressureSystem& system, int axis) {
  const int count = value_count(domain, axis);
  std::vector<double> greatest(std::size_t{2} * count, -std::numeric_limits<double>::infinity());
  for_each_field(domain, system, axis,
                 [&](const Array3<double>& c, const IndexBox& box, int first) {
                   if (box.empty()) return;
                   for (int n = box.lo[axis]; n < box.hi[axis]; ++n) {
                     Int3 at = box.lo;
                     at[axis] = n;
                     const double value = c(at[0], at[1], at[2]);
                     greatest[first + n] = value;
                     greatest[count + first + n] = -value;
                   }
                 });
  MPI_Allreduce(MPI_IN_PLACE, greatest.data(), 2 * count, MPI_DOUBLE, MPI_MAX,
                domain.comm().handle());
  for (int n = 0; n < count; ++n)
    if (std::isfinite(greatest[n]) && !equal(greatest[n], -greatest[count + n])) return false;
  return true;
}

}  // namespace

std::vector<int> layer_axes(const PressureSystem& system) {
  std::vector<int> axes;
  for (const int axis : {2, 0, 1}) {
    const auto plane = plane_axes(axis);
    if (transformable(system, plane[0]) && transformable(system, plane[1])) axes.push_back(axis);
  }
  return axes;
}

int layered_axis(const Domain& domain, const PressureSystem& system) {
  for (const int axis : layer_axes(system)) {
    const bool here = layered_on_this_rank(domain, system, axis);
    if (domain.comm().min(here ? 1.0 : 0.0) == 0.0) continue;
    if (domain.comm().size() == 1 || layers_agree(domain, system, axis)) return axis;
  }
  return -1;
}

// Sums of 1 / c for the coefficients of faces, and of storage as it is.
Layers layer_means(const Domain& domain, const PressureSystem& system, int axis) {
  const int cells = domain.grid().cells[axis];
  const int count = value_count(domain, axis);
  const int first_of_storage = 3 * cells + 1;
  std::vector<double> sums(std::size_t{2} * count, 0.0);  // and the number of summands
  for_each_field(domain, system, axis,
                 [&](const Array3<double>& c, const IndexBox& box, int first) {
                   const bool harmonic = first != first_of_storage;
                   for_each_cell(box, [&](int i, int j, int k) {
                     const int n = first + Int3{i, j, k}[axis];
                     sums[n] += harmonic ? 1 / c(i, j, k) : c(i, j, k);
                     sums[count + n] += 1;
                   });
                 });
  domain.comm().sum_in_place(sums);
  std::vector<double> mean(count, 0.0);
  for (int n = 0; n < count; ++n) {
    if (sums[count + n] == 0) continue;
    mean[n] = sums[n] / sums[count + n];
    if (n < first_of_storage) mean[n] = 1 / mean[n];  // 0 of faces that are closed
  }
  if (domain.grid().periodic[axis]) mean[cells] = mean[0];

  Layers layers;
  layers.axis = axis;
  const auto part = [&](int first, int number) {
    return std::vector<double>(mean.begin() + first, mean.begin() + first + number);
  };
  layers.across = part(0, cells + 1);
  layers.along = {part(cells + 1, cells), part(2 * cells + 1, cells)};
  layers.storage = part(first_of_storage, cells);
  return layers;
}

}  // namespace gasgrain
