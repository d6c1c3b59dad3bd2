#include "gas_solver/gas_step.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "gas_solver/mass_source.h"
#include "gas_solver/operators/quantity.h"
#include "gas_solver/operators/require_finite.h"
#include "gas_solver/operators/runaway.h"

namespace gasgrain {
namespace {

constexpr long max_steps = 1000000;  // of an interval

GasInput joined(GasInput input) {
  input.join_periodic_sides();
  return input;
}

}  // namespace

GasSolver::GasSolver(const GasInput& input, const Communicator& comm)
    : input_(joined(input)),
      domain_(input_.grid, comm),
      halo_(domain_),
      hydrostatic_(input_),
      inflow_(domain_, input_.inflows, input_.density),
      state_(domain_.box()),
      levels_(input_, domain_.box(), state_),
      predictor_(domain_, input_, halo_),
      projection_(domain_, input_, halo_),
      front_view_(domain_, input_.surface_solids, input_.bubble_void_fraction),
      probes_(domain_, input_.pressure_probes),
      means_(domain_, input_),
      void_fraction_to_(domain_.box(), 1.0),
      task_setup_(costs_.task("setup")),
      task_boundaries_(costs_.task("boundaries")),
      task_momentum_(costs_.task("momentum")),
      task_pressure_(costs_.task("pressure")),
      task_means_(costs_.task("means")),
      task_measures_(costs_.task("measures")) {
  if (hydrostatic_.compressibility() > 0) {
    state_.density = Array3<double>(domain_.box());
    for_each_cell(own(), [&](int i, int j, int k) {
      state_.density(i, j, k) = hydrostatic_.density(i, j, k);
    });
    halo_.exchange({&state_.density});
    fill_ghost_cells(domain_, state_.density);
  }
  if (input_.turbulence.model != TurbulenceModel::none) {
    turbulence_.emplace(domain_, input_, halo_);
    task_turbulence_ = costs_.task("turbulence");
  }
  if (!input_.mass_sources.empty())
    set_mass_source(mass_source_field(domain_, input_.mass_sources));
  costs_.charge(task_setup_, costs_.age() - costs_.named());
}

void GasSolver::set_void_fraction(const Array3<double>& eps) {
  for_each_cell(own(), [&](int i, int j, int k) { void_fraction_to_(i, j, k) = eps(i, j, k); });
  halo_.exchange({&void_fraction_to_});
  fill_ghost_cells(domain_, void_fraction_to_);
  if (!has_void_fraction_) {
    state_.void_fraction = void_fraction_to_;
    projection_.update_fluxes(state_, inflow_.at(time_, state_.density));
  }
  has_void_fraction_ = true;
}

void GasSolver::set_drag(const Array3<double>& coefficient, const CellVector& source) {
  auto& [sx, sy, sz] = state_.drag_source;
  for_each_cell(own(), [&](int i, int j, int k) {
    state_.drag_coefficient(i, j, k) = coefficient(i, j, k);
    for (int d = 0; d < 3; ++d) state_.drag_source[d](i, j, k) = source[d](i, j, k);
  });
  halo_.exchange({&state_.drag_coefficient, &sx, &sy, &sz});
  for (Array3<double>* field : {&state_.drag_coefficient, &sx, &sy, &sz})
    fill_ghost_cells(domain_, *field);
}

void GasSolver::set_mass_source(const Array3<double>& source) {
  if (state_.mass_source.size() == 0) state_.mass_source = Array3<double>(domain_.box());
  for_each_cell(own(), [&](int i, int j, int k) { state_.mass_source(i, j, k) = source(i, j, k); });
  halo_.exchange({&state_.mass_source});
  fill_ghost_cells(domain_, state_.mass_source);
}

GasReport GasSolver::advance(double interval) {
  if (!(interval > 0))
    fail("the gas cannot advance by {} s: the interval must be positive.", interval);
  GasReport report;
  report.step = interval;
  means_.begin(state_.velocity, interval);
  const double begin = time_;
  double done = 0;
  while (done < interval) {
    const double left = interval - done;
    const double wanted = next_step(left, interval);
    if (left > max_steps * wanted)
      fail(
          "at t = {:.9g} s the gas needs more than {} steps for the {:.3g} s that are left of an "
          "interval: [time] step = {} s or courant_max = {} is too small, or the flow has run away "
          "(greatest |u| / h = {:.3g} 1/s).",
          time_, max_steps, left, input_.step, input_.courant_max,
          courant_rate(domain_, state_.velocity));
    // A last step takes all that is left, so that no remainder of round-off follows it.
    const int steps = static_cast<int>(std::ceil(left / wanted * (1 - 1e-12)));
    const double dt = steps <= 1 ? left : left / steps;
    done = steps <= 1 ? interval : done + dt;
    time_ = begin + done;
    step(dt, steps <= 1 ? 1.0 : dt / left, report);
    const Stopwatch watch(costs_, task_means_);
    // What acted on the grains in the step: Crank-Nicolson's drag is that of both its ends.
    const double weight = dt / interval;
    const double at_end = time_weight(input_.scheme);
    means_.add_velocity(state_.velocity, at_end * weight);
    if (at_end < 1) means_.add_velocity(levels_.velocity_before(state_), (1 - at_end) * weight);
    means_.add_pressure(state_, weight);
  }
  report.time = time_;
  {
    const Stopwatch watch(costs_, task_means_);
    means_.end(state_.velocity, interval);
    report.drag_impulse = means_.drag_force(state_) * interval;
  }
  measure(report);
  return report;
}

const std::vector<InflowFace>& GasSolver::begin_step(double dt, double share) {
  const Stopwatch watch(costs_, task_boundaries_);
  levels_.begin(state_, dt, void_fraction_to_, share);
  const std::vector<InflowFace>& inflow = inflow_.at(time_, state_.density);
  for (const InflowFace& face : inflow)
    state_.velocity[axis_of(face.side)](face.face[0], face.face[1], face.face[2]) =
        is_high(face.side) ? -face.volume_flux : face.volume_flux;
  fill_velocity_layers();
  return inflow;
}

void GasSolver::step(double dt, double share, GasReport& report) {
  const std::vector<InflowFace>& inflow = begin_step(dt, share);
  if (turbulence_) {
    const Stopwatch watch(costs_, task_turbulence_);
    const TurbulenceReport done = turbulence_->update(state_, dt, inflow);
    report.turbulence_clamped += done.floored + done.capped;
    report.turbulence_not_converged += done.not_converged;
  }
  predict_and_project(dt, inflow, report);
  const Stopwatch watch(costs_, task_measures_);
  require_finite(domain_, state_, time_);
  report.substeps += 1;
  report.step = std::min(report.step, dt);
  report.courant_max = std::max(report.courant_max, dt * courant_rate(domain_, state_.velocity));
}

void GasSolver::predict_and_project(double dt, const std::vector<InflowFace>& inflow,
                                    GasReport& report) {
  const bool outer = input_.pressure_velocity != PressureVelocity::projection;
  const int most = outer ? input_.outer_iterations : 1;
  ProjectionReport done;
  bool converged = !outer;
  for (int n = 0; n < most; ++n) {
    if (n > 0) levels_.iterate(state_);
    {
      const Stopwatch watch(costs_, task_momentum_);
      report.momentum_not_converged +=
          predictor_.predict(state_, {dt, levels_.velocity_before(state_), inflow, turbulence()})
              .not_converged;
    }
    const Stopwatch watch(costs_, task_pressure_);
    done = projection_.project(state_, dt, inflow, predictor_.mobility());
    report.pressure_iterations += done.iterations;
    ++report.outer_iterations;
    if (outer && done.mass_defect <= input_.outer_tolerance) {
      converged = true;
      break;
    }
  }
  if (!converged) ++report.outer_not_converged;
  if (done.continuity_residual > input_.tolerance) ++report.pressure_not_converged;
  report.mass_defect = std::max(report.mass_defect, done.mass_defect);
  report.continuity_residual = std::max(report.continuity_residual, done.continuity_residual);
  report.mass_imbalance = std::max(report.mass_imbalance, done.mass_imbalance);
  report.mass_inflow = done.sides.mass_inflow;
  report.mass_outflow = done.sides.mass_outflow;
  report.backflow_faces = done.sides.backflow_faces;
}

void GasSolver::fill_velocity_layers() {
  auto& [u, v, w] = state_.velocity;
  halo_.exchange({&u, &v, &w});
  for (int d = 0; d < 3; ++d) fill_ghost_velocities(domain_, input_.walls(), d, state_.velocity[d]);
}

double GasSolver::next_step(double left, double interval) {
  const Stopwatch watch(costs_, task_boundaries_);
  inflow_.at(time_ + input_.step, state_.density);
  const CourantRates rates{courant_rate(domain_, state_.velocity),
                           domain_.comm().max(inflow_.courant_rate())};
  require_bounded(domain_, input_, state_.velocity, rates, interval, time_);
  const double rate = std::max(rates.flow, rates.inflow);
  return std::min({input_.step, left, rate > 0 ? input_.courant_max / rate : left});
}

void GasSolver::measure(GasReport& report) {
  const Stopwatch watch(costs_, task_measures_);
  report.probe_pressure = probes_.measure(state_.pressure, hydrostatic_, input_.outlet_pressure);
  report.mass = gas_mass();
  const BedShape bed = front_view_.measure(state_.void_fraction);
  report.surface_height = bed.surface_height;
  report.bubble_diameter = bed.bubble_diameter;
}

double GasSolver::gas_mass() const {
  double sum = 0;
  std::visit(
      [&](const auto& rho) {
        for_each_cell(own(), [&](int i, int j, int k) {
          const auto o = state_.void_fraction.offset(i, j, k);
          sum += rho(o) * state_.void_fraction[o];
        });
      },
      quantity(state_.density, input_.density));
  return domain_.comm().sum(sum) * grid().cell_volume();
}

}  // namespace gasgrain
