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

// laplace u_a + 1/3 d/dx_a div u at the face at offset o.
double viscous_at_face(const CellVector& u, const VelocityGradient& gradient, const Vec3& per_h,
                       int a, std::ptrdiff_t o) {
  const auto divergence = [&](std::ptrdiff_t cell) {
    return gradient.along(0, cell) + gradient.along(1, cell) + gradient.along(2, cell);
  };
  double sum = per_h[a] / 3.0 * (divergence(o) - divergence(o - u[a].stride(a)));
  for (int b = 0; b < 3; ++b) {
    const std::ptrdiff_t s = u[a].stride(b);
    sum += per_h[b] * per_h[b] * (u[a][o + s] - 2.0 * u[a][o] + u[a][o - s]);
  }
  return sum;
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
  const VelocityGradient gradient(u, spacing);
  for (int d = 0; d < 3; ++d) {
    const std::ptrdiff_t s = u[d].stride(d);
    // Half of the force of an inner face acts on either cell beside it, all of it on a cell whose
    // other face is on a side.
    const IndexBox own = domain.own();
    const int first = domain.touches(side_of(d, false)) ? own.lo[d] : own.lo[d] - 1;
    const int last = domain.touches(side_of(d, true)) ? own.hi[d] - 1 : own.hi[d];
    for_each_cell(own, [&](int i, int j, int k) {
      const auto o = u[d].offset(i, j, k);
      const int n = d == 0 ? i : (d == 1 ? j : k);
      double force = 0;
      int faces = 0;
      if (n != first) {
        force += viscous_at_face(u, gradient, per_h, d, o);
        ++faces;
      }
      if (n != last) {
        force += viscous_at_face(u, gradient, per_h, d, o + s);
        ++faces;
      }
      if (faces > 0) sum[d](i, j, k) += weight * viscosity * force / faces;
    });
  }
}

}  // namespace gasgrain
