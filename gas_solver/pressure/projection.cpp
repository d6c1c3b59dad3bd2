#include "gas_solver/pressure/projection.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/listed.h"
#include "gas_solver/momentum/finish_rows.h"
#include "gas_solver/operators/quantity.h"

namespace gasgrain {
namespace {

void remove_mean(const Domain& domain, Array3<double>& cells) {
  double sum = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) { sum += cells(i, j, k); });
  const double mean = domain.comm().sum(sum) / static_cast<double>(domain.grid().all().size());
  for_each_cell(domain.own(), [&](int i, int j, int k) { cells(i, j, k) -= mean; });
}

}  // namespace

Projection::Projection(const Domain& domain, const GasInput& input, Halo& halo)
    : domain_(domain),
      walls_(input.walls()),
      density_(input.density),
      compressibility_(Hydrostatic(input).compressibility()),
      theta_(time_weight(input.scheme)),
      whole_gradient_(input.model == GasModel::b),
      tolerance_(input.tolerance),
      spacing_(input.grid.spacing()),
      halo_(halo),
      flux_(domain, input, halo),
      system_(domain, input.sides),
      solver_(domain, input.pressure) {
  if (input.pressure_velocity != PressureVelocity::projection)
    relax_pressure_ = input.relax_pressure;
  if (compressibility_ > 0) system_.storage = Array3<double>(domain.own());
  system_.singular = !input.has_outlet() && compressibility_ == 0;
}

ProjectionReport Projection::project(GasState& state, double step,
                                     const std::vector<InflowFace>& inflow,
                                     const CellVector& mobility) {
  ProjectionReport report;
  flux_.update(state, inflow);
  set_coefficients(state, step, mobility);
  set_source(state, step);
  const double defect = greatest_source();
  const double scale = flow_scale(state, step, flux_.measure(state).mass_inflow);
  // Without an outlet only sources that sum to 0 can be met; what is taken off stays in the
  // residual.
  if (system_.singular) remove_mean(domain_, system_.source);
  report.iterations = solver_.solve(system_, tolerance_ * scale);
  if (system_.singular) remove_mean(domain_, system_.solution);
  correct(state, step, mobility);
  flux_.update(state, inflow);
  if (compressibility_ > 0) compress(state);
  report.sides = flux_.measure(state);
  set_source(state, step);
  const auto relative = [scale](double mass) { return mass == 0 ? 0 : mass / scale; };
  report.mass_defect = relative(defect);
  report.continuity_residual = relative(greatest_source());
  double sum = 0;
  for (const double mass : system_.source) sum += mass;
  report.mass_imbalance = relative(std::abs(domain_.comm().sum(sum)));
  return report;
}

template <class InnerFace, class OutletFace>
void Projection::for_each_moved_face(const GasState& state, double step, int axis,
                                     const CellVector& mobility, InnerFace&& at_inner,
                                     OutletFace&& at_outlet) {
  const Array3<double>& eps = state.momentum_void_fraction();
  const Array3<double>& drag = state.drag_coefficient;
  const std::ptrdiff_t s = eps.stride(axis);
  const bool known = mobility[axis].size() > 0;
  const double per_step = 1.0 / step;
  const auto w = [&](std::ptrdiff_t o, double eps_f, double rho, double k) {
    return known ? mobility[axis][o]
                 : (whole_gradient_ ? 1.0 : eps_f) / (rho * per_step * eps_f + theta_ * k);
  };
  IndexBox faces = domain_.inner_faces(axis);
  if (!domain_.touches(side_of(axis, true)))
    ++faces.hi[axis];  // the high face of the last own cell
  visit_apart(
      [&](const auto& rho) {
        for_each_cell(faces, [&](int i, int j, int k) {
          const auto o = eps.offset(i, j, k);
          const double rho_f = face_value(rho, o, s);
          at_inner(o, w(o, face_mean(eps, o, s), rho_f, face_mean(drag, o, s)), rho_f);
        });
        for (const bool high : {false, true}) {
          const int side = side_of(axis, high);
          if (walls_.sides[side]->normal_velocity_given) continue;
          for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
            const auto o = eps.offset(i, j, k);
            const auto cell = o + inner_cell_offset(side, s);
            at_outlet(o, w(o, eps[cell], rho(cell), drag[cell]), rho(cell), cell,
                      high ? 1.0 : -1.0);
          });
        }
      },
      quantity(state.density, density_));
}

void Projection::set_coefficients(const GasState& state, double step, const CellVector& mobility) {
  const double volume = domain_.grid().cell_volume();
  const Array3<double>& eps = state.void_fraction;
  for (int d = 0; d < 3; ++d) {
    Array3<double>& c = system_.face_coefficient[d];
    const std::ptrdiff_t s = eps.stride(d);
    // Face area / h; a cell that is its own neighbour round a periodic axis has no gradient.
    const bool alone = domain_.grid().periodic[d] && domain_.grid().cells[d] == 1;
    const double per_gradient = alone ? 0.0 : volume / (spacing_[d] * spacing_[d]);
    for_each_moved_face(
        state, step, d, mobility,
        [&](std::ptrdiff_t o, double w, double rho) {
          c[o] = per_gradient * rho * face_mean(eps, o, s) * w;
        },
        [&](std::ptrdiff_t o, double w, double rho, std::ptrdiff_t cell, double) {
          c[o] = 2.0 * per_gradient * rho * eps[cell] * w;  // h / 2 apart
        });
  }
  if (compressibility_ == 0) return;
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    system_.storage(i, j, k) = volume * compressibility_ / step * eps(i, j, k);
  });
}

void Projection::set_source(const GasState& state, double step) {
  const double volume = domain_.grid().cell_volume();
  const Vec3 area = volume * spacing_.cwiseInverse();
  const auto& flux = state.mass_flux;
  const std::ptrdiff_t sy = flux[0].stride(1);
  const std::ptrdiff_t sz = flux[0].stride(2);
  const double per_step = volume / step;
  const bool sources = state.mass_source.size() > 0;
  visit_apart(
      [&](const auto& rho, const auto& rho_before) {
        for_each_cell(domain_.own(), [&](int i, int j, int k) {
          const auto o = flux[0].offset(i, j, k);
          system_.source(i, j, k) = -per_step * (rho(o) * state.void_fraction[o] -
                                                 rho_before(o) * state.void_fraction_before[o]) -
                                    (flux[0][o + 1] - flux[0][o]) * area[0] -
                                    (flux[1][o + sy] - flux[1][o]) * area[1] -
                                    (flux[2][o + sz] - flux[2][o]) * area[2];
          if (sources) system_.source(i, j, k) += volume * state.mass_source[o];
        });
      },
      quantity(state.density, density_), quantity(state.density_before, density_));
}

double Projection::greatest_source() const {
  double greatest = 0;
  for (const double mass : system_.source) greatest = std::max(greatest, std::abs(mass));
  return domain_.comm().max(greatest);
}

void Projection::correct(GasState& state, double step, const CellVector& mobility) {
  Array3<double>& dp = system_.solution;
  halo_.exchange({&dp});
  for (int d = 0; d < 3; ++d) {
    const std::ptrdiff_t s = dp.stride(d);
    Array3<double>& u = state.velocity[d];
    const double per_h = 1.0 / spacing_[d];
    for_each_moved_face(
        state, step, d, mobility,
        [&](std::ptrdiff_t o, double w, double) { u[o] -= w * (dp[o] - dp[o - s]) * per_h; },
        [&](std::ptrdiff_t o, double w, double, std::ptrdiff_t cell, double outward) {
          u[o] -= w * outward * (0.0 - dp[cell]) * 2.0 * per_h;
        });
  }
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    state.pressure(i, j, k) += relax_pressure_ * dp(i, j, k);
  });
  halo_.exchange({&state.pressure, &state.velocity[0], &state.velocity[1], &state.velocity[2]});
  fill_ghost_cells(domain_, state.pressure);
  for (int d = 0; d < 3; ++d) fill_ghost_velocities(domain_, walls_, d, state.velocity[d]);
}

void Projection::compress(GasState& state) {
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    state.density(i, j, k) += compressibility_ * system_.solution(i, j, k);
  });
  halo_.exchange({&state.density});
  fill_ghost_cells(domain_, state.density);
}

// The greatest of: what flows in, what moving grains displace and sources bring, what passes any
// one face [kg/s].
double Projection::flow_scale(const GasState& state, double step, double inflow) const {
  const double volume = domain_.grid().cell_volume();
  double stored = 0;
  double through_face = 0;
  const bool sources = state.mass_source.size() > 0;
  visit_apart(
      [&](const auto& rho, const auto& rho_before) {
        for_each_cell(domain_.own(), [&](int i, int j, int k) {
          const auto o = state.void_fraction.offset(i, j, k);
          stored += std::abs(rho(o) * state.void_fraction[o] -
                             rho_before(o) * state.void_fraction_before[o]) /
                    step;
          if (sources) stored += std::abs(state.mass_source[o]);
          for (int d = 0; d < 3; ++d)
            through_face =
                std::max(through_face, std::abs(state.mass_flux[d][o]) * volume / spacing_[d]);
        });
      },
      quantity(state.density, density_), quantity(state.density_before, density_));
  stored = domain_.comm().sum(stored) * 0.5 * volume;
  return std::max({inflow, stored, domain_.comm().max(through_face)});
}

}  // namespace gasgrain
