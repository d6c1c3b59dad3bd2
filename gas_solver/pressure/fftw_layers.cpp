#include "gas_solver/pressure/fftw_layers.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {
namespace {

// Coefficients that differ by less than this share count as equal: round-off of their means.
constexpr double equal_within = 1e-13;

// Both sides of the axis give the normal velocity, or are one.
bool transformable(const PressureSystem& system, int axis) {
  const BoundaryKind& lo = *system.sides[side_of(axis, false)];
  const BoundaryKind& hi = *system.sides[side_of(axis, true)];
  return lo.periodic || (lo.normal_velocity_given && hi.normal_velocity_given);
}

// The coefficients of each layer across `axis` are those of its first cell, and those of the two
// axes in the layer change along `axis` only.
bool layered(const Domain& domain, const PressureSystem& system, int axis) {
  const IndexBox own = domain.own();
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& c = system.face_coefficient[d];
    IndexBox faces = d == axis ? domain.faces(d) : domain.inner_faces(d);
    if (faces.empty()) continue;
    for (int k = faces.lo[2]; k < faces.hi[2]; ++k)
      for (int j = faces.lo[1]; j < faces.hi[1]; ++j)
        for (int i = faces.lo[0]; i < faces.hi[0]; ++i) {
          Int3 first = faces.lo;
          first[axis] = Int3{i, j, k}[axis];
          const double expected = c(first[0], first[1], first[2]);
          if (std::abs(c(i, j, k) - expected) > equal_within * expected) return false;
        }
  }
  return !own.empty();
}

fftw_r2r_kind kind(const Domain& domain, int axis, bool forward) {
  if (domain.grid().periodic[axis]) return forward ? FFTW_R2HC : FFTW_HC2R;
  return forward ? FFTW_REDFT10 : FFTW_REDFT01;
}

}  // namespace

FftwFit fftw_fit(const Domain& domain, const PressureSystem& system) {
  if (domain.comm().size() > 1) return {-1, "it runs on one gas rank only"};
  bool any_direction = false;
  for (const int axis : {2, 0, 1}) {
    const auto [a, b] = plane_axes(axis);
    if (!transformable(system, a) || !transformable(system, b)) continue;
    any_direction = true;
    if (layered(domain, system, axis)) return {axis, ""};
  }
  if (!any_direction) return {-1, "outlets lie on the sides of more than one axis"};
  return {-1, "void fraction or drag change along more than one axis"};
}

FftwLayers::FftwLayers(const Domain& domain, int axis)
    : domain_(domain), axis_(axis), work_(domain.own()) {
  const auto plane = plane_axes(axis);
  const Int3& cells = domain.grid().cells;
  std::array<fftw_iodim, 2> dims;
  std::array<fftw_r2r_kind, 2> forth;
  std::array<fftw_r2r_kind, 2> back;
  for (int n = 0; n < 2; ++n) {
    const int d = plane[n];
    const int stride = static_cast<int>(work_.stride(d));
    dims[n] = {cells[d], stride, stride};
    forth[n] = kind(domain, d, true);
    back[n] = kind(domain, d, false);
    const bool periodic = domain.grid().periodic[d];
    scale_ /= (periodic ? 1.0 : 2.0) * cells[d];
    for (int m = 0; m < cells[d]; ++m) {
      const double angle = (periodic ? 2.0 : 1.0) * M_PI * m / cells[d];
      eigenvalue_[n].push_back(2.0 - 2.0 * std::cos(angle));
    }
  }
  const int stride = static_cast<int>(work_.stride(axis));
  const fftw_iodim layers{cells[axis], stride, stride};
  double* data = work_.data();
  forward_ =
      fftw_plan_guru_r2r(2, dims.data(), 1, &layers, data, data, forth.data(), FFTW_ESTIMATE);
  backward_ =
      fftw_plan_guru_r2r(2, dims.data(), 1, &layers, data, data, back.data(), FFTW_ESTIMATE);
  across_.resize(cells[axis] + 1);
  for (auto& coefficients : along_) coefficients.resize(cells[axis]);
  upper_.resize(cells[axis]);
  rest_.resize(cells[axis]);
  corner_.resize(cells[axis]);
}

FftwLayers::~FftwLayers() {
  fftw_destroy_plan(forward_);
  fftw_destroy_plan(backward_);
}

void FftwLayers::solve(PressureSystem& system) {
  work_ = system.source;
  fftw_execute(forward_);
  read_layers(system);
  const auto plane = plane_axes(axis_);
  const Int3& cells = domain_.grid().cells;
  for (int m2 = 0; m2 < cells[plane[1]]; ++m2)
    for (int m1 = 0; m1 < cells[plane[0]]; ++m1)
      solve_line(system, m1, m2,
                 work_.data() + m1 * work_.stride(plane[0]) + m2 * work_.stride(plane[1]),
                 work_.stride(axis_));
  fftw_execute(backward_);
  for_each_cell(domain_.own(),
                [&](int i, int j, int k) { system.solution(i, j, k) = work_(i, j, k) * scale_; });
}

// Face coefficients of the layers: across_[n] between layers n-1 and n, along_ within a layer.
void FftwLayers::read_layers(const PressureSystem& system) {
  const int cells = domain_.grid().cells[axis_];
  const auto value = [&](int axis, int layer) {
    Int3 at = domain_.inner_faces(axis).lo;  // 0, or 1 where face 0 is a side's
    at[axis_] = layer;
    return system.face_coefficient[axis](at[0], at[1], at[2]);
  };
  for (int n = 0; n <= cells; ++n) across_[n] = value(axis_, n);
  if (domain_.grid().periodic[axis_] && cells == 1) across_.assign(2, 0.0);
  const auto plane = plane_axes(axis_);
  for (int d = 0; d < 2; ++d)
    for (int n = 0; n < cells; ++n) along_[d][n] = value(plane[d], n);
}

// Thomas' algorithm. Round a periodic axis the last unknown is set apart: the others are solved for
// the source and for a unit value of the last one, and the last row then gives it.
void FftwLayers::solve_line(const PressureSystem& system, int m1, int m2, double* line,
                            std::ptrdiff_t stride) {
  const int cells = domain_.grid().cells[axis_];
  const bool cyclic = domain_.grid().periodic[axis_] && cells > 1;
  const bool pinned = system.singular && m1 == 0 && m2 == 0;
  const auto below = [&](int n) { return across_[n]; };
  const auto centre = [&](int n) {
    return across_[n] + across_[n + 1] + along_[0][n] * eigenvalue_[0][m1] +
           along_[1][n] * eigenvalue_[1][m2];
  };
  // The mode that no coefficient fixes: its last value is set to 0.
  const int unknowns = cyclic || pinned ? cells - 1 : cells;
  double before_upper = 0;
  for (int n = 0; n < unknowns; ++n) {
    const double lower = n > 0 ? below(n) : 0.0;
    double pivot = centre(n);
    pivot -= lower * before_upper;
    upper_[n] = below(n + 1) / pivot;
    rest_[n] = (line[n * stride] + (n > 0 ? lower * rest_[n - 1] : 0.0)) / pivot;
    const double to_last = n == 0 && cyclic ? below(0) : 0.0;
    corner_[n] = (to_last + (n > 0 ? lower * corner_[n - 1] : 0.0)) / pivot;
    before_upper = upper_[n];
  }
  if (cyclic && unknowns > 0) corner_[unknowns - 1] += upper_[unknowns - 1];
  for (int n = unknowns - 2; n >= 0; --n) {
    rest_[n] += upper_[n] * rest_[n + 1];
    corner_[n] += upper_[n] * corner_[n + 1];
  }
  double last = 0;
  if (cyclic && !pinned) {
    const double left = below(cells - 1);
    const double right = below(cells);
    last = (line[(cells - 1) * stride] + left * rest_[cells - 2] + right * rest_[0]) /
           (centre(cells - 1) - left * corner_[cells - 2] - right * corner_[0]);
  }
  for (int n = 0; n < unknowns; ++n) line[n * stride] = rest_[n] + (cyclic ? corner_[n] * last : 0);
  if (unknowns < cells) line[(cells - 1) * stride] = last;
}

}  // namespace gasgrain
