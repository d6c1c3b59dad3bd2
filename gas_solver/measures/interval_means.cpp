#include "gas_solver/measures/interval_means.h"

#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/operators/quantity.h"

namespace gasgrain {

IntervalMeans::IntervalMeans(const Domain& domain, const GasInput& input)
    : velocity(make_vector(domain.own())),
      pressure_gradient(make_vector(domain.own())),
      domain_(domain),
      sides_(input.sides),
      whole_gradient_(input.model == GasModel::b),
      density_(input.density),
      compressibility_(Hydrostatic(input).compressibility()),
      gravity_(Hydrostatic(input).gravity_at_rest()) {
  for (int d = 0; d < 3; ++d) pressure_gradient[d].fill(density_ * gravity_[d]);
}

void IntervalMeans::clear() {
  for (int d = 0; d < 3; ++d) {
    velocity[d].fill(0.0);
    pressure_gradient[d].fill(0.0);
  }
}

void IntervalMeans::add_velocity(const CellVector& faces, double weight) {
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& u = faces[d];
    const std::ptrdiff_t s = u.stride(d);
    for_each_cell(domain_.own(), [&](int i, int j, int k) {
      const auto o = u.offset(i, j, k);
      velocity[d](i, j, k) += weight * 0.5 * (u[o] + u[o + s]);
    });
  }
}

void IntervalMeans::add_pressure(const GasState& state, double weight) {
  const IndexBox own = domain_.own();
  const Array3<double>& p = state.pressure;
  std::visit(
      [&](const auto& rho) {
        for (int d = 0; d < 3; ++d) {
          const std::ptrdiff_t s = p.stride(d);
          const double per_h = 1.0 / domain_.grid().spacing()[d];
          const double share = whole_gradient_ ? 0.0 : 1.0;
          const bool lo = domain_.touches(side_of(d, false));
          const bool hi = domain_.touches(side_of(d, true));
          const bool lo_given = lo && sides_[side_of(d, false)]->normal_velocity_given;
          const bool hi_given = hi && sides_[side_of(d, true)]->normal_velocity_given;
          for_each_cell(own, [&](int i, int j, int k) {
            const auto o = p.offset(i, j, k);
            const int n = d == 0 ? i : (d == 1 ? j : k);
            const bool first = lo && n == own.lo[d];
            const bool last = hi && n == own.hi[d] - 1;
            double below = (first ? 2.0 * p[o] : p[o] - p[o - s]) * per_h;
            double above = (last ? -2.0 * p[o] : p[o + s] - p[o]) * per_h;
            if (first && lo_given) below = last && hi_given ? 0.0 : above;
            if (last && hi_given) above = below;
            const double rest = (rho(o) - share * compressibility_ * p[o]) * gravity_[d];
            pressure_gradient[d](i, j, k) += weight * (share * 0.5 * (below + above) + rest);
          });
        }
      },
      quantity(state.density, density_));
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
