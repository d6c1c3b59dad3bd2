#include "gas_solver/measures/interval_means.h"

#include "coupling/base/listed.h"
#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/measures/cell_means.h"
#include "gas_solver/operators/quantity.h"

namespace gasgrain {

IntervalMeans::IntervalMeans(const Domain& domain, const GasInput& input)
    : velocity(make_vector(domain.own())),
      pressure_gradient(make_vector(domain.own())),
      domain_(domain),
      walls_(input.walls()),
      whole_gradient_(input.model == GasModel::b),
      density_(input.density),
      viscosity_(input.viscosity),
      compressibility_(Hydrostatic(input).compressibility()),
      gravity_(Hydrostatic(input).gravity_at_rest()) {
  for (int d = 0; d < 3; ++d) pressure_gradient[d].fill(density_ * gravity_[d]);
}

void IntervalMeans::ask_for(const FurtherMeans& further) {
  further_ = further;
  const IndexBox own = domain_.own();
  with_walls_ = further.any() ? make_vector(domain_.box()) : CellVector{};
  vorticity = further.vorticity ? make_vector(own) : CellVector{};
  acceleration = further.acceleration ? make_vector(own) : CellVector{};
  viscous_force = further.viscous_force ? make_vector(own) : CellVector{};
}

void IntervalMeans::begin(const CellVector& faces, double interval) {
  for (CellVector* mean :
       {&velocity, &pressure_gradient, &vorticity, &acceleration, &viscous_force})
    for (auto& component : *mean) component.fill(0.0);
  if (further_.acceleration) add_cell_velocity(domain_, faces, -1.0 / interval, acceleration);
}

void IntervalMeans::end(const CellVector& faces, double interval) {
  if (further_.acceleration) add_cell_velocity(domain_, faces, 1.0 / interval, acceleration);
}

void IntervalMeans::add_velocity(const CellVector& faces, double weight) {
  add_cell_velocity(domain_, faces, weight, velocity);
  if (!further_.any()) return;
  with_walls_ = faces;
  for (int d = 0; d < 3; ++d) fill_parabolic_velocities(domain_, walls_, d, with_walls_[d]);
  if (further_.vorticity) add_vorticity(domain_, with_walls_, weight, vorticity);
  if (further_.acceleration) add_convection(domain_, with_walls_, weight, acceleration);
  if (further_.viscous_force)
    add_viscous_force(domain_, with_walls_, viscosity_, weight, viscous_force);
}

void IntervalMeans::add_pressure(const GasState& state, double weight) {
  const IndexBox own = domain_.own();
  const Array3<double>& p = state.pressure;
  visit_apart(
      [&](const auto& rho) {
        for (int d = 0; d < 3; ++d) {
          const std::ptrdiff_t s = p.stride(d);
          const double per_h = 1.0 / domain_.grid().spacing()[d];
          const double share = whole_gradient_ ? 0.0 : 1.0;
          const bool lo = domain_.touches(side_of(d, false));
          const bool hi = domain_.touches(side_of(d, true));
          const bool lo_given = lo && walls_.sides[side_of(d, false)]->normal_velocity_given;
          const bool hi_given = hi && walls_.sides[side_of(d, true)]->normal_velocity_given;
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
