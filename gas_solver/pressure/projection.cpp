#include "gas_solver/pressure/projection.h"

#include <algorithm>
#include <cmath>

#include "gas_solver/boundary/unknown_faces.h"

namespace gasgrain {
namespace {

// eps / (rho eps / dt + K)
inline double mobility(double eps, double drag, double inertia) {
  return eps / (inertia * eps + drag);
}

void remove_mean(const Domain& domain, Array3<double>& cells) {
  double sum = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) { sum += cells(i, j, k); });
  const double mean = domain.comm().sum(sum) / static_cast<double>(domain.grid().all().size());
  for_each_cell(domain.own(), [&](int i, int j, int k) { cells(i, j, k) -= mean; });
}

}  // namespace

Projection::Projection(const Domain& domain, const GasInput& input, Halo& halo)
    : domain_(domain),
      sides_(input.sides),
      density_(input.density),
      tolerance_(input.tolerance),
      spacing_(input.grid.spacing()),
      halo_(halo),
      system_(domain, input.sides),
      solver_(domain, input.pressure) {
  system_.singular = !input.has_outlet();
}

ProjectionReport Projection::project(GasState& state, double step,
                                     const std::vector<InflowFace>& inflow) {
  ProjectionReport report;
  update_fluxes(state, inflow);
  measure_sides(state, report);
  const double scale = flow_scale(state, step, report);
  set_coefficients(state, step);
  set_source(state, step);
  // Without an outlet only sources that sum to 0 can be met; what is taken off stays in the
  // residual.
  if (system_.singular) remove_mean(domain_, system_.source);
  report.iterations = solver_.solve(system_, tolerance_ * scale / density_);
  if (system_.singular) remove_mean(domain_, system_.solution);
  correct(state, step);
  update_fluxes(state, inflow);

  ProjectionReport after;
  measure_sides(state, after);
  after.iterations = report.iterations;
  set_source(state, step);
  double worst = 0;
  for (const double value : system_.source) worst = std::max(worst, std::abs(value));
  worst = domain_.comm().max(worst);
  after.continuity_residual = worst == 0 ? 0 : worst * density_ / scale;
  return after;
}

void Projection::update_fluxes(GasState& state, const std::vector<InflowFace>& inflow) {
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& eps = state.void_fraction;
    const Array3<double>& u = state.velocity[d];
    Array3<double>& flux = state.mass_flux[d];
    const std::ptrdiff_t s = eps.stride(d);
    IndexBox faces = domain_.inner_faces(d);
    faces.hi[d] = std::max(faces.hi[d], domain_.own().hi[d]);
    for_each_cell(faces, [&](int i, int j, int k) {
      const auto o = eps.offset(i, j, k);
      flux[o] = density_ * face_mean(eps, o, s) * u[o];
    });
    for (const bool high : {false, true}) {
      const int side = side_of(d, high);
      const bool open = !sides_[side]->normal_velocity_given;
      for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
        const auto o = eps.offset(i, j, k);
        flux[o] = open ? density_ * eps[o + inner_cell_offset(side, s)] * u[o] : 0.0;
      });
    }
  }
  for (const InflowFace& face : inflow) {
    const double into = is_high(face.side) ? -1.0 : 1.0;
    const Int3& f = face.face;
    state.mass_flux[axis_of(face.side)](f[0], f[1], f[2]) = into * density_ * face.volume_flux;
  }
  halo_.exchange({&state.mass_flux[0], &state.mass_flux[1], &state.mass_flux[2]});
  for (int d = 0; d < 3; ++d) fill_ghost_fluxes(domain_, d, state.mass_flux[d]);
}

void Projection::set_coefficients(const GasState& state, double step) {
  const double inertia = density_ / step;
  const double volume = domain_.grid().cell_volume();
  const Array3<double>& eps = state.void_fraction;
  for (int d = 0; d < 3; ++d) {
    Array3<double>& c = system_.face_coefficient[d];
    const std::ptrdiff_t s = eps.stride(d);
    // Face area / h; a cell that is its own neighbour round a periodic axis has no gradient.
    const bool alone = domain_.grid().periodic[d] && domain_.grid().cells[d] == 1;
    const double per_gradient = alone ? 0.0 : volume / (spacing_[d] * spacing_[d]);
    IndexBox faces = domain_.own();
    ++faces.hi[d];
    for_each_cell(faces, [&](int i, int j, int k) {
      const auto o = eps.offset(i, j, k);
      const double eps_f = face_mean(eps, o, s);
      c[o] =
          per_gradient * eps_f * mobility(eps_f, face_mean(state.drag_coefficient, o, s), inertia);
    });
    for (const bool high : {false, true}) {
      const int side = side_of(d, high);
      const double open = sides_[side]->normal_velocity_given ? 0.0 : 2.0;  // h / 2 apart
      for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) { c(i, j, k) *= open; });
    }
  }
}

void Projection::set_source(const GasState& state, double step) {
  const double volume = domain_.grid().cell_volume();
  const Vec3 per_flux = volume * spacing_.cwiseInverse() / density_;  // face area / rho
  const auto& flux = state.mass_flux;
  const std::ptrdiff_t sy = flux[0].stride(1);
  const std::ptrdiff_t sz = flux[0].stride(2);
  const double displaced = volume / step;
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = flux[0].offset(i, j, k);
    system_.source(i, j, k) =
        -displaced * (state.void_fraction[o] - state.void_fraction_before[o]) -
        (flux[0][o + 1] - flux[0][o]) * per_flux[0] - (flux[1][o + sy] - flux[1][o]) * per_flux[1] -
        (flux[2][o + sz] - flux[2][o]) * per_flux[2];
  });
}

void Projection::correct(GasState& state, double step) {
  Array3<double>& dp = system_.solution;
  halo_.exchange({&dp});
  const double inertia = density_ / step;
  const Array3<double>& eps = state.void_fraction;
  for (int d = 0; d < 3; ++d) {
    const std::ptrdiff_t s = eps.stride(d);
    Array3<double>& u = state.velocity[d];
    const double per_h = 1.0 / spacing_[d];
    for_each_cell(domain_.inner_faces(d), [&](int i, int j, int k) {
      const auto o = eps.offset(i, j, k);
      u[o] -= mobility(face_mean(eps, o, s), face_mean(state.drag_coefficient, o, s), inertia) *
              (dp[o] - dp[o - s]) * per_h;
    });
    for (const bool high : {false, true}) {
      const int side = side_of(d, high);
      if (sides_[side]->normal_velocity_given) continue;
      for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
        const auto o = eps.offset(i, j, k);
        const auto cell = o + inner_cell_offset(side, s);
        const double outward = high ? 1.0 : -1.0;
        u[o] -= mobility(eps[cell], state.drag_coefficient[cell], inertia) * outward *
                (0.0 - dp[cell]) * 2.0 * per_h;
      });
    }
  }
  for_each_cell(domain_.own(),
                [&](int i, int j, int k) { state.pressure(i, j, k) += dp(i, j, k); });
  halo_.exchange({&state.pressure, &state.velocity[0], &state.velocity[1], &state.velocity[2]});
  fill_ghost_cells(domain_, state.pressure);
  for (int d = 0; d < 3; ++d) fill_ghost_velocities(domain_, sides_, d, state.velocity[d]);
}

// The greatest of: what flows in, what the moving grains displace, what passes any one face [kg/s].
double Projection::flow_scale(const GasState& state, double step,
                              const ProjectionReport& report) const {
  const double volume = domain_.grid().cell_volume();
  double displaced = 0;
  double through_face = 0;
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = state.void_fraction.offset(i, j, k);
    displaced += std::abs(state.void_fraction[o] - state.void_fraction_before[o]);
    for (int d = 0; d < 3; ++d)
      through_face = std::max(through_face, std::abs(state.mass_flux[d][o]) * volume / spacing_[d]);
  });
  displaced = domain_.comm().sum(displaced) * 0.5 * density_ * volume / step;
  return std::max({report.mass_inflow, displaced, domain_.comm().max(through_face)});
}

void Projection::measure_sides(const GasState& state, ProjectionReport& report) const {
  std::vector<double> sums(3, 0.0);  // inflow, outflow, faces of backflow
  for (int side = 0; side < side_count; ++side) {
    const int d = axis_of(side);
    const double area = domain_.grid().cell_volume() / spacing_[d];
    const double outward = is_high(side) ? 1.0 : -1.0;
    const bool open = !sides_[side]->normal_velocity_given;
    for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
      const double out = outward * state.mass_flux[d](i, j, k) * area;
      sums[open ? 1 : 0] += open ? out : -out;
      if (open && out < 0) sums[2] += 1;
    });
  }
  domain_.comm().sum_in_place(sums);
  report.mass_inflow = sums[0];
  report.mass_outflow = sums[1];
  report.backflow_faces = static_cast<long>(sums[2]);
}

}  // namespace gasgrain
