#include "gas_solver/measures/interval_means.h"

namespace gasgrain {

IntervalMeans::IntervalMeans(const Domain& domain, const Sides& sides, const Vec3& rest_gradient)
    : domain_(domain), sides_(sides), rest_gradient_(rest_gradient) {
  for (int d = 0; d < 3; ++d) {
    velocity[d] = Array3<double>(domain.own());
    pressure_gradient[d] = Array3<double>(domain.own(), rest_gradient[d]);
  }
}

void IntervalMeans::clear() {
  for (int d = 0; d < 3; ++d) {
    velocity[d].fill(0.0);
    pressure_gradient[d].fill(0.0);
  }
}

void IntervalMeans::add(const GasState& state, double weight) {
  const IndexBox own = domain_.own();
  const Vec3 h = domain_.grid().spacing();
  const Array3<double>& p = state.pressure;
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& u = state.velocity[d];
    const std::ptrdiff_t s = u.stride(d);
    const double per_h = 1.0 / h[d];
    const double rest = rest_gradient_[d];
    const bool lo = domain_.touches(side_of(d, false));
    const bool hi = domain_.touches(side_of(d, true));
    const bool lo_given = lo && sides_[side_of(d, false)]->normal_velocity_given;
    const bool hi_given = hi && sides_[side_of(d, true)]->normal_velocity_given;
    for_each_cell(own, [&](int i, int j, int k) {
      const auto o = u.offset(i, j, k);
      const int n = d == 0 ? i : (d == 1 ? j : k);
      velocity[d](i, j, k) += weight * 0.5 * (u[o] + u[o + s]);
      const bool first = lo && n == own.lo[d];
      const bool last = hi && n == own.hi[d] - 1;
      double below = (first ? 2.0 * p[o] : p[o] - p[o - s]) * per_h;
      double above = (last ? -2.0 * p[o] : p[o + s] - p[o]) * per_h;
      if (first && lo_given) below = last && hi_given ? 0.0 : above;
      if (last && hi_given) above = below;
      pressure_gradient[d](i, j, k) += weight * (0.5 * (below + above) + rest);
    });
  }
}

Vec3 IntervalMeans::drag_force(const GasState& state) const {
  Vec3 force = Vec3::Zero();
  for (int d = 0; d < 3; ++d)
    for_each_cell(domain_.own(), [&](int i, int j, int k) {
      force[d] +=
          state.drag_coefficient(i, j, k) * velocity[d](i, j, k) - state.drag_source[d](i, j, k);
    });
  return domain_.comm().sum(force) * domain_.grid().cell_volume();
}

}  // namespace gasgrain
