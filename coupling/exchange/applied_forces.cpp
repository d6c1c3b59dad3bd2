#include "coupling/exchange/applied_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/base/error.h"
#include "coupling/base/listed.h"

namespace gasgrain {
namespace {

// Their records, forces and velocities are some 100 KiB, so that the second pass over them finds
// them in a near cache.
constexpr std::size_t particles_at_once = 512;

// (1 - exp(-a)) / a - 1, to round-off of the sum 1 + this.
double less_by_response(double a) {
  constexpr double series = 1e-3;  // beyond it the fourth term is more than round-off
  if (a < series) return -a * (1.0 / 2 - a * (1.0 / 6 - a * (1.0 / 24 - a * (1.0 / 120))));
  return -std::expm1(-a) / a - 1.0;
}

template <class Chosen>
const Chosen* named(const Effects& effects) {
  for (const auto& force : effects.forces)
    if (const auto* found = chosen_as<Chosen>(force)) return found;
  return nullptr;
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
      added_mass_(named<ForceVirtualMass>(effects) != nullptr),
      costs_(effects.names().size()) {
  if (const auto* basset = named<ForceBasset>(effects)) basset_ = *basset;
  clear();
}

// The memory's numbers belong to one length of step.
void ForceLoop::make_memory(double dt) {
  if (memory_ && dt != dt_of_memory_)
    fail(
        "the DEM step has changed from {} s to {} s while the basset force is on: its memory is of "
        "the old step. Keep the timestep, or leave basset out.",
        dt_of_memory_, dt);
  if (!memory_) memory_ = basset_->memory(dt);
  dt_of_memory_ = dt;
}

void ForceLoop::clear() {
  applied_ = {};
  applied_.work.assign(effects_.names().size(), 0.0);
}

void ForceLoop::apply(const ParticleView& particles, ExchangeRecords& records,
                      const HostForces& host, double dt, double share) {
  if (basset_) make_memory(dt);
  costs_.begin_step();
  for (std::size_t begin = 0; begin < particles.count; begin += particles_at_once) {
    const Block block{begin, std::min(begin + particles_at_once, particles.count)};
    if (block.begin == 0 && costs_.wants_parts())
      time_solve(block, particles, records, host.force, dt);
    costs_.start();
    add_steady(block, particles, records, host, share * dt);
    costs_.pass_done(costs_.row_of_every_step());
    add_motions(block, particles, records, host, share * dt);
    if (!added_mass_ && !basset_ && !own_drag_) continue;
    solve(block, particles, records, host.force, dt, share);
    costs_.solve_done();
  }
}

void ForceLoop::add_steady(Block block, const ParticleView& particles, ExchangeRecords& records,
                           const HostForces& host, double duration) {
  const int reaction = records.layout().reaction;
  Vec3 of_host = Vec3::Zero();
  Vec3 steady = Vec3::Zero();
  Vec3 reacting = Vec3::Zero();
  for (std::size_t p = block.begin; p < block.end; ++p) {
    Eigen::Map<Vec3> force(host.force + 3 * p);
    const double N = particles.N(p);
    of_host += N * force;
    steady += N * records.steady_force(p);
    force += records.steady_force(p);
    if (reaction < 0) continue;
    records.taken(p) += records.at(p, reaction) * duration;
    reacting += N * records.at(p, reaction);
    applied_.exchanged += N * records.at(p, reaction).lpNorm<1>() * duration;
  }
  applied_.host += of_host * duration;
  applied_.reacting += reacting * duration;
  applied_.free += (steady - reacting) * duration;
}

void ForceLoop::add_motions(Block block, const ParticleView& particles, ExchangeRecords& records,
                            const HostForces& host, double duration) {
  std::size_t n = effects_.drag ? 1 : 0;
  for (const Force& force : effects_.forces) {
    visit_apart(
        [&](const auto& chosen) {
          using Chosen = std::decay_t<decltype(chosen)>;
          if constexpr (Chosen::kind == ForceKind::motion || Chosen::kind == ForceKind::torque) {
            applied_.work[n] += add_motion(chosen, block, particles, records, host, duration);
            costs_.pass_done(n);
          }
        },
        force);
    ++n;
  }
}

template <class Motion>
double ForceLoop::add_motion(const Motion& motion, Block block, const ParticleView& particles,
                             ExchangeRecords& records, const HostForces& host, double duration) {
  double work = 0.0;
  Vec3 impulse = Vec3::Zero();
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const GasAtParticle at = gas_at(records, p);
    const GrainState grain = grain_of(particles, p);
    const double N = particles.N(p);
    if constexpr (Motion::kind == ForceKind::torque) {
      const Vec3 torque = motion.torque(gas_, at, grain);
      Eigen::Map<Vec3>(host.torque + 3 * p) += torque;
      work += N * torque.lpNorm<1>() * duration;
    } else {
      const Vec3 force = motion.force(gas_, at, grain);
      Eigen::Map<Vec3>(host.force + 3 * p) += force;
      if constexpr (Motion::reacts) records.taken(p) += force * duration;
      impulse += N * force * duration;
      work += N * force.lpNorm<1>() * duration;
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

void ForceLoop::solve(Block block, const ParticleView& particles, ExchangeRecords& records,
                      double* force, double dt, double share) {
  const bool inertia = added_mass_ || memory_;
  if (particles.parcel_size == nullptr) {
    if (inertia)
      solve_motion<true, false>(block, particles, records, force, dt, share);
    else
      solve_motion<false, false>(block, particles, records, force, dt, share);
  } else {
    if (inertia)
      solve_motion<true, true>(block, particles, records, force, dt, share);
    else
      solve_motion<false, true>(block, particles, records, force, dt, share);
  }
}

template <bool with_inertia, bool parcels>
void ForceLoop::solve_motion(Block block, const ParticleView& particles, ExchangeRecords& records,
                             double* force, double dt, double share) {
  double impulse[3] = {0.0, 0.0, 0.0};
  double drag_work = 0.0;
  double virtual_mass_work = 0.0;
  double history_work = 0.0;
  const RecordLayout& layout = records.layout();
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const double K = own_drag_ ? records.K(p) : 0.0;
    const double mass = particles.mass[p];
    [[maybe_unused]] const double N = parcels ? particles.parcel_size[p] : 1.0;
    [[maybe_unused]] double virtual_mass = 0.0;
    [[maybe_unused]] double history_mass = 0.0;
    [[maybe_unused]] Vec3 history = Vec3::Zero();
    [[maybe_unused]] Vec3 rate = Vec3::Zero();  // Du/Dt - dv/dt
    if constexpr (with_inertia) {
      if (added_mass_) virtual_mass = ForceVirtualMass::added_mass(gas_, particles.radius[p]);
      if (memory_) {
        history_mass = memory_->added_mass(gas_, particles.radius[p]);
        history = memory_->history(gas_, particles.radius[p], records.row(p) + layout.history);
      }
    }
    const double added = virtual_mass + history_mass;
    const double less = less_by_response(K * dt / (mass + added));
    const auto u = records.u(p);
    auto taken = records.taken(p);
    double of_drag = 0.0;
    for (int d = 0; d < 3; ++d) {
      double& total = force[3 * p + d];
      const double pull = K * (u[d] - particles.velocity[3 * p + d]);
      double gain;
      if constexpr (with_inertia) {
        const double of_gas = records.row(p)[layout.acceleration + d];
        const double drive = pull + total + history[d] + added * of_gas;
        const double acceleration = (1.0 + less) * drive / (mass + added);
        rate[d] = of_gas - acceleration;
        gain = mass * acceleration - total;
        const double of_virtual_mass = virtual_mass * rate[d];
        const double of_history = history_mass * rate[d] + history[d];
        virtual_mass_work += N * std::abs(of_virtual_mass);
        history_work += N * std::abs(of_history);
        of_drag += std::abs(gain - of_virtual_mass - of_history);
      } else {
        gain = pull + less * (pull + total);
        of_drag += std::abs(gain);
      }
      total += gain;
      taken[d] += gain * share * dt;
      impulse[d] += N * gain;
    }
    drag_work += N * of_drag;
    // The first half of a step after a start is no step of the memory.
    if constexpr (with_inertia)
      if (memory_ && share == 1.0) memory_->advance(records.row(p) + layout.history, rate);
  }
  const double duration = share * dt;
  applied_.reacting += Vec3(impulse[0], impulse[1], impulse[2]) * duration;
  std::size_t n = 0;
  const auto book = [&](double work) {
    applied_.work[n] += work * duration;
    applied_.exchanged += work * duration;
  };
  if (effects_.drag) {
    if (own_drag_) book(drag_work);
    ++n;
  }
  for (const Force& chosen : effects_.forces) {
    if (chosen_as<ForceVirtualMass>(chosen) != nullptr) book(virtual_mass_work);
    if (chosen_as<ForceBasset>(chosen) != nullptr) book(history_work);
    ++n;
  }
}

// The same loop over copies, with the effects that are solved together switched on one by one.
void ForceLoop::time_solve(Block block, const ParticleView& particles,
                           const ExchangeRecords& records, const double* force, double dt) {
  const std::size_t count = block.end - block.begin;
  ParticleView some = particles;
  some.count = count;
  some.velocity += 3 * block.begin;
  some.radius += block.begin;
  some.mass += block.begin;
  if (some.parcel_size != nullptr) some.parcel_size += block.begin;
  const auto seconds = [&](ForceLoop& trial) {
    constexpr int repeats = 3;  // the shortest is that which nothing interrupted
    double shortest = std::numeric_limits<double>::max();
    for (int n = 0; n < repeats; ++n) {
      ExchangeRecords copies(records.layout());
      copies.resize(count);
      std::copy(records.row(block.begin), records.row(block.end), copies.row(0));
      std::vector<double> forces(force + 3 * block.begin, force + 3 * block.end);
      const WallClock clock;
      trial.solve({0, count}, some, copies, forces.data(), dt, 1.0);
      shortest = std::min(shortest, clock.seconds());
    }
    return shortest;
  };
  ForceLoop trial = *this;
  trial.own_drag_ = trial.added_mass_ = false;
  trial.memory_.reset();
  double before = 0.0;
  const auto switched_on = [&](std::size_t row) {
    const double now = seconds(trial);
    // What is too short for the clock, of a handful of particles, has all of the pass.
    constexpr double tick = 1e-9;
    costs_.add_part(row, std::max(now - before, before > 0.0 ? 0.0 : tick));
    before = std::max(now, before);
  };
  std::size_t row = 0;
  if (effects_.drag) {
    if ((trial.own_drag_ = own_drag_)) switched_on(row);
    ++row;
  }
  for (const Force& chosen : effects_.forces) {
    if (chosen_as<ForceVirtualMass>(chosen) != nullptr) {
      trial.added_mass_ = true;
      switched_on(row);
    }
    if (chosen_as<ForceBasset>(chosen) != nullptr) {
      trial.memory_ = memory_;
      switched_on(row);
    }
    ++row;
  }
}

}  // namespace gasgrain
