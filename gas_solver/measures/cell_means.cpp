#include "gas_solver/measures/cell_means.h"

#include "gas_solver/operators/velocity_gradient.h"

namespace gasgrain {
namespace {

// The two axes that follow an axis in turn.
constexpr int after(int axis) {
  return (axis + 1) % 3;
}
constexpr int before(int axis) {
  return (axis + 2) % 3;
}

double cell_velocity(const Array3<double>& u, std::ptrdiff_t o, int axis) {
  return 0.5 * (u[o] + u[o + u.stride(axis)]);
}

Array3<double> divergence_of(const Domain& domain, const VelocityGradient& gradient) {
  Array3<double> divergence(domain.box());
  for_each_cell(domain.own().grown(1), [&](int i, int j, int k) {
    const auto o = divergence.offset(i, j, k);
    divergence[o] = gradient.along(0, o) + gradient.along(1, o) + gradient.along(2, o);
  });
  return divergence;
}

}  // namespace

void add_cell_velocity(const Domain& domain, const CellVector& u, double weight, CellVector& sum) {
  for (int d = 0; d < 3; ++d)
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      sum[d](i, j, k) += weight * cell_velocity(u[d], u[d].offset(i, j, k), d);
    });
}

void add_vorticity(const Domain& domain, const CellVector& u, double weight, CellVector& sum) {
  const VelocityGradient gradient(u, domain.grid().spacing());
  for (int d = 0; d < 3; ++d) {
    const int e = after(d);
    const int f = before(d);
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const auto o = u[d].offset(i, j, k);
      sum[d](i, j, k) += weight * (gradient.across(f, e, o) - gradient.across(e, f, o));
    });
  }
}

void add_convection(const Domain& domain, const CellVector& u, double weight, CellVector& sum) {
  const VelocityGradient gradient(u, domain.grid().spacing());
  for (int d = 0; d < 3; ++d) {
    const int e = after(d);
    const int f = before(d);
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const auto o = u[d].offset(i, j, k);
      sum[d](i, j, k) += weight * (cell_velocity(u[d], o, d) * gradient.along(d, o) +
                                   cell_velocity(u[e], o, e) * gradient.across(d, e, o) +
                                   cell_velocity(u[f], o, f) * gradient.across(d, f, o));
    });
  }
}

void add_viscous_force(const Domain& domain, const CellVector& u, double viscosity, double weight,
                       CellVector& sum) {
  const Vec3 spacing = domain.grid().spacing();
  const Vec3 per_h = spacing.cwiseInverse();
  const Vec3 per_h2 = per_h.cwiseProduct(per_h);
  const Array3<double> divergence = divergence_of(domain, VelocityGradient(u, spacing));
  const double* const div = divergence.data();
  const IndexBox own = domain.own();
  Array3<double> at_faces(domain.box());  // over viscosity
  double* const force = at_faces.data();
  for (int d = 0; d < 3; ++d) {
    const double* const v = u[d].data();
    const std::array<std::ptrdiff_t, 3> t{u[d].stride(0), u[d].stride(1), u[d].stride(2)};
    const std::ptrdiff_t s = t[d];
    // Inner faces of the own cells.
    const bool lo = domain.touches(side_of(d, false));
    const bool hi = domain.touches(side_of(d, true));
    IndexBox faces = own;
    if (lo) ++faces.lo[d];
    if (!hi) ++faces.hi[d];
    for_each_cell(faces, [&](int i, int j, int k) {
      const auto o = at_faces.offset(i, j, k);
      const double twice = 2.0 * v[o];
      force[o] = per_h2[0] * (v[o + t[0]] - twice + v[o - t[0]]) +
                 per_h2[1] * (v[o + t[1]] - twice + v[o - t[1]]) +
                 per_h2[2] * (v[o + t[2]] - twice + v[o - t[2]]) +
                 per_h[d] / 3.0 * (div[o] - div[o - s]);
    });
    for_each_cell(own, [&](int i, int j, int k) {
      const auto o = at_faces.offset(i, j, k);
      const int n = d == 0 ? i : (d == 1 ? j : k);
      const bool first = lo && n == own.lo[d];
      const bool last = hi && n == own.hi[d] - 1;
      if (first && last) return;
      const double below = force[first ? o + s : o];
      const double above = force[last ? o : o + s];
      sum[d](i, j, k) += weight * viscosity * 0.5 * (below + above);
    });
  }
}

}  // namespace gasgrain
