#include "coupling/exchange/applied_forces.h"

#include <cmath>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

// (1 - exp(-a)) / a - 1, to round-off of the sum 1 + this.
double less_by_response(double a) {
  constexpr double series = 1e-3;  // beyond it the fourth term is more than round-off
  if (a < series) return -a * (1.0 / 2 - a * (1.0 / 6 - a * (1.0 / 24 - a * (1.0 / 120))));
  return -std::expm1(-a) / a - 1.0;
}

bool has_added_mass(const Effects& effects) {
  for (const auto& force : effects.forces)
    if (std::visit([](const auto& chosen) { return chosen.kind == ForceKind::added_mass; }, force))
      return true;
  return false;
}

GasAtParticle gas_at(const ExchangeRecords& records, std::size_t p) {
  const RecordLayout& layout = records.layout();
  GasAtParticle at;
  at.velocity = records.u(p);
  if (layout.vorticity >= 0) at.vorticity = records.at(p, layout.vorticity);
  if (layout.acceleration >= 0) at.acceleration = records.at(p, layout.acceleration);
  return at;
}

GrainState grain_of(const ParticleView& particles, std::size_t p) {
  GrainState grain{particles.v(p), Vec3::Zero(), particles.radius[p]};
  if (particles.angular_velocity != nullptr)
    grain.angular_velocity = Eigen::Map<const Vec3>(particles.angular_velocity + 3 * p);
  return grain;
}

}  // namespace

ForceLoop::ForceLoop(const Effects& effects, const GasProperties& gas)
    : effects_(effects),
      gas_(gas),
      own_drag_(effects.drag && effects.own_drag()),
      added_mass_(has_added_mass(effects)) {
  clear();
}

void ForceLoop::clear() {
  applied_ = {};
  applied_.work.assign(effects_.names().size(), 0.0);
}

void ForceLoop::apply(const ParticleView& particles, ExchangeRecords& records,
                      const HostForces& host, double dt, double share) {
  const double duration = share * dt;
  const int reaction = records.layout().reaction;
  Vec3 of_host = Vec3::Zero();
  Vec3 steady = Vec3::Zero();
  Vec3 reacting = Vec3::Zero();
  for (std::size_t p = 0; p < particles.count; ++p) {
    Eigen::Map<Vec3> force(host.force + 3 * p);
    of_host += force;
    steady += records.steady_force(p);
    force += records.steady_force(p);
    if (reaction < 0) continue;
    records.taken(p) += records.at(p, reaction) * duration;
    reacting += records.at(p, reaction);
    applied_.exchanged += records.at(p, reaction).lpNorm<1>() * duration;
  }
  applied_.host += of_host * duration;
  applied_.reacting += reacting * duration;
  applied_.free += (steady - reacting) * duration;

  std::size_t n = effects_.drag ? 1 : 0;
  for (const Force& force : effects_.forces) {
    std::visit(
        [&](const auto& chosen) {
          using Chosen = std::decay_t<decltype(chosen)>;
          if constexpr (Chosen::kind == ForceKind::motion || Chosen::kind == ForceKind::torque)
            applied_.work[n] += add_motion(chosen, particles, records, host, duration);
        },
        force);
    ++n;
  }
  if (own_drag_ && added_mass_)
    solve_motion<true, true>(particles, records, host.force, dt, share);
  else if (own_drag_)
    solve_motion<true, false>(particles, records, host.force, dt, share);
  else if (added_mass_)
    solve_motion<false, true>(particles, records, host.force, dt, share);
}

template <class Motion>
double ForceLoop::add_motion(const Motion& motion, const ParticleView& particles,
                             ExchangeRecords& records, const HostForces& host, double duration) {
  double work = 0.0;
  Vec3 impulse = Vec3::Zero();
  for (std::size_t p = 0; p < particles.count; ++p) {
    const GasAtParticle at = gas_at(records, p);
    const GrainState grain = grain_of(particles, p);
    if constexpr (Motion::kind == ForceKind::torque) {
      const Vec3 torque = motion.torque(gas_, at, grain);
      Eigen::Map<Vec3>(host.torque + 3 * p) += torque;
      work += torque.lpNorm<1>() * duration;
    } else {
      const Vec3 force = motion.force(gas_, at, grain);
      Eigen::Map<Vec3>(host.force + 3 * p) += force;
      if constexpr (Motion::reacts) records.taken(p) += force * duration;
      impulse += force * duration;
      work += force.lpNorm<1>() * duration;
    }
  }
  if constexpr (Motion::kind == ForceKind::motion && Motion::reacts) {
    applied_.reacting += impulse;
    applied_.exchanged += work;
  } else {
    applied_.free += impulse;
  }
  return work;
}

template <bool with_drag, bool with_added_mass>
void ForceLoop::solve_motion(const ParticleView& particles, ExchangeRecords& records, double* force,
                             double dt, double share) {
  double impulse[3] = {0.0, 0.0, 0.0};
  double drag_work = 0.0;
  double added_work = 0.0;
  for (std::size_t p = 0; p < particles.count; ++p) {
    double* record = records.row(p);
    const double K = with_drag ? records.K(p) : 0.0;
    double added = 0.0;
    if constexpr (with_added_mass) added = added_mass(particles.radius[p]);
    const double mass = particles.mass[p];
    const double inertia = mass + added;
    const double less = less_by_response(K * dt / inertia);
    const Eigen::Map<const Vec3> u = std::as_const(records).u(p);
    Eigen::Map<Vec3> taken = records.taken(p);
    for (int d = 0; d < 3; ++d) {
      double& total = force[3 * p + d];
      const double pull = K * (u[d] - particles.velocity[3 * p + d]);
      double gain;
      if constexpr (with_added_mass) {
        const double gas_acceleration = record[records.layout().acceleration + d];
        const double drive = pull + total + added * gas_acceleration;
        const double acceleration = (1.0 + less) * drive / inertia;
        const double of_mass = added * (gas_acceleration - acceleration);
        gain = mass * acceleration - total;
        added_work += std::abs(of_mass);
        drag_work += std::abs(gain - of_mass);
      } else {
        gain = pull + less * (pull + total);
        drag_work += std::abs(gain);
      }
      total += gain;
      taken[d] += gain * share * dt;
      impulse[d] += gain;
    }
  }
  const double duration = share * dt;
  applied_.reacting += Vec3(impulse[0], impulse[1], impulse[2]) * duration;
  applied_.exchanged += (drag_work + added_work) * duration;
  std::size_t n = 0;
  if (effects_.drag) applied_.work[n++] += with_drag ? drag_work * duration : 0.0;
  if constexpr (with_added_mass)
    for (const Force& chosen : effects_.forces) {
      if (std::visit([](const auto& f) { return f.kind == ForceKind::added_mass; }, chosen))
        applied_.work[n] += added_work * duration;
      ++n;
    }
}

// Of the virtual mass [kg].
double ForceLoop::added_mass(double radius) const {
  double sum = 0.0;
  for (const Force& force : effects_.forces)
    std::visit(
        [&](const auto& chosen) {
          using Chosen = std::decay_t<decltype(chosen)>;
          if constexpr (Chosen::kind == ForceKind::added_mass)
            sum += Chosen::added_mass(gas_, radius);
        },
        force);
  return sum;
}

}  // namespace gasgrain
