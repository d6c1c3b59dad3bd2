#include "coupling/exchange/particle_exchange.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {
namespace {

const VectorField& required(const VectorField* field, GasField which) {
  if (field == nullptr)
    fail("the field {} was not returned by the gas although an effect of the scene needs it",
         info(which).name);
  return *field;
}

template <bool with_drag, bool with_steady>
AppliedDrag apply(const ParticleView& particles, ExchangeRecord* records, double* force,
                  double dt) {
  double impulse[3] = {0.0, 0.0, 0.0};
  double magnitude[3] = {0.0, 0.0, 0.0};
  for (std::size_t p = 0; p < particles.count; ++p) {
    ExchangeRecord& record = records[p];
    for (int d = 0; d < 3; ++d) {
      double total = 0.0;
      if constexpr (with_drag) {
        const double drag = record.K * (record.u[d] - particles.velocity[3 * p + d]);
        record.taken[d] += drag * dt;
        impulse[d] += drag * dt;
        magnitude[d] += std::abs(drag) * dt;
        total += drag;
      }
      if constexpr (with_steady) total += record.steady_force[d];
      force[3 * p + d] += total;
    }
  }
  return {Vec3(impulse[0], impulse[1], impulse[2]), magnitude[0] + magnitude[1] + magnitude[2]};
}

// Adds one steady force to the records; returns the sum of its absolute components [N].
template <class Steady>
double add_steady(const ParticleView& particles, const ParticleWeights& weights,
                  const LentFields& lent, ExchangeRecord* records) {
  static_assert(Steady::lent().bits() == FieldSet().add(GasField::pressure_gradient).bits(),
                "a steady force that needs another field must have it sampled here");
  double magnitude = 0.0;
  weights.sample(required(lent.pressure_gradient, GasField::pressure_gradient),
                 [&](std::size_t p, const Vec3& gradient) {
                   GasAtParticle at;
                   at.pressure_gradient = gradient;
                   const Vec3 force = Steady::force(GasProperties{}, at, particles.radius[p]);
                   as_vec3(records[p].steady_force) += force;
                   magnitude += force.lpNorm<1>();
                 });
  return magnitude;
}

}  // namespace

void deposit_solid_volume(const ParticleView& particles, const ParticleWeights& weights,
                          Array3<double>& solid_volume) {
  weights.deposit([&](std::size_t p) { return sphere_volume(particles.radius[p]); }, solid_volume);
}

DragRefresh refresh_drag(const ParticleView& particles, const ParticleWeights& weights,
                         const DragModel& model, const GasProperties& gas,
                         const Array3<double>& void_fraction, const VectorField& gas_velocity,
                         ExchangeRecord* records) {
  // The void fraction waits in K and the gas velocity in u until the law is evaluated.
  weights.sample(void_fraction, [&](std::size_t p, double eps) { records[p].K = eps; });
  weights.sample(gas_velocity, [&](std::size_t p, const Vec3& u) { as_vec3(records[p].u) = u; });
  constexpr double round_off = 1e-9;  // cells filled to the gas's own limit are at the bound
  DragRefresh refresh;
  std::visit(
      [&](const auto& law) {
        for (std::size_t p = 0; p < particles.count; ++p) {
          ExchangeRecord& record = records[p];
          const double eps = record.K;
          if (eps < least_drag_void_fraction - round_off) ++refresh.too_dense;
          refresh.least_void_fraction = std::min(refresh.least_void_fraction, eps);
          const double met = std::clamp(eps, least_drag_void_fraction, 1.0);
          record.K = law.coefficient(gas, met, (as_vec3(record.u) - particles.v(p)).norm(),
                                     2.0 * particles.radius[p]);
          if (gas.whole_pressure_gradient) record.K /= met;
        }
      },
      model);
  return refresh;
}

void deposit_drag(const ParticleView& particles, const ParticleWeights& weights,
                  const ExchangeRecord* records, double cell_volume, double interval,
                  Array3<double>& drag_coefficient, VectorField& drag_source) {
  const double per_volume = 1.0 / cell_volume;
  weights.deposit([&](std::size_t p) { return records[p].K * per_volume; }, drag_coefficient);
  weights.deposit(
      [&](std::size_t p) -> Vec3 {
        return (records[p].K * particles.v(p) - carry(records[p]) / interval) * per_volume;
      },
      drag_source);
}

std::vector<double> set_records(const ParticleView& particles, const ParticleWeights& weights,
                                const Effects& effects, const LentFields& lent, double interval,
                                ExchangeRecord* records) {
  for (std::size_t p = 0; p < particles.count; ++p) {
    records[p].steady_force.fill(0.0);
    records[p].taken.fill(0.0);
  }
  if (effects.drag)
    weights.sample(required(lent.velocity, GasField::velocity), [&](std::size_t p, const Vec3& u) {
      as_vec3(records[p].u) = u;
      as_vec3(records[p].expected) = records[p].K * interval * (u - particles.v(p));
    });
  std::vector<double> work;
  for (const auto& force : effects.forces)
    work.push_back(interval * std::visit(
                                  [&](const auto& chosen) {
                                    return add_steady<std::decay_t<decltype(chosen)>>(
                                        particles, weights, lent, records);
                                  },
                                  force));
  return work;
}

AppliedDrag apply_forces(const ParticleView& particles, const Effects& effects,
                         ExchangeRecord* records, double* force, double dt) {
  const bool steady = !effects.forces.empty();
  if (effects.drag && steady) return apply<true, true>(particles, records, force, dt);
  if (effects.drag) return apply<true, false>(particles, records, force, dt);
  if (steady) return apply<false, true>(particles, records, force, dt);
  return {};
}

Vec3 outstanding_carry(std::size_t count, const ExchangeRecord* records) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t p = 0; p < count; ++p) sum += carry(records[p]);
  return sum;
}

}  // namespace gasgrain
