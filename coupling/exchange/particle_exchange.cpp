#include "coupling/exchange/particle_exchange.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/cost_ledger.h"
#include "coupling/base/listed.h"
#include "coupling/exchange/drag/polydisperse.h"

namespace gasgrain {
namespace {

// Coefficient [kg/s] and velocity [m/s] of the grain by which the gas is charged.
[[gnu::always_inline]] inline double gas_coefficient(const ExchangeRecords& records, bool by_mean,
                                                     std::size_t p) {
  return by_mean ? records.row(p)[records.layout().mean_coefficient] : records.K(p);
}
[[gnu::always_inline]] inline Vec3 gas_counterpart(const ParticleView& particles,
                                                   const ExchangeRecords& records, bool by_mean,
                                                   std::size_t p) {
  if (by_mean) return records.at(p, records.layout().mean_velocity);
  return particles.v(p);
}

// u: of the gas that answers [m/s].
[[gnu::always_inline]] inline void expect(const ParticleView& particles, bool by_mean,
                                          std::size_t p, const Vec3& u, double interval,
                                          ExchangeRecords& records) {
  records.expected(p) = gas_coefficient(records, by_mean, p) * interval *
                        (u - gas_counterpart(particles, records, by_mean, p));
}

void expect_nothing(const ParticleView& particles, ExchangeRecords& records) {
  for (std::size_t p = 0; p < particles.count; ++p) records.expected(p).setZero();
}

// Steady forces depend on one field each.
constexpr GasField only_field(FieldSet set) {
  GasField found = gas_field_list[0].field;
  for (const GasFieldInfo& field : gas_field_list)
    if (set.has(field.field)) found = field.field;
  return found;
}

template <class Steady>
double add_steady(const ParticleView& particles, const ParticleWeights& weights,
                  const GasProperties& gas, const FieldStore& fields, ExchangeRecords& records) {
  constexpr GasField field = only_field(Steady::lent());
  static_assert(Steady::lent().bits() == FieldSet().add(field).bits());
  const int reaction = records.layout().reaction;
  double magnitude = 0.0;
  weights.sample(fields.vector(field), [&](std::size_t p, const Vec3& value) {
    GasAtParticle at;
    place(at, field) = value;
    const Vec3 force = Steady::force(gas, at, particles.radius[p]);
    records.steady_force(p) += force;
    if constexpr (Steady::reacts) records.at(p, reaction) += force;
    magnitude += particles.N(p) * force.lpNorm<1>();
  });
  return magnitude;
}

struct SelfDisturbance {
  double alone = 0.0;
  double own_solids = 0.0;  // solid fraction of itself that the particle sees
  Footprint footprint;
};

// Of particles that have others near nothing is asked for, which would be the dearer part.
[[gnu::always_inline]] inline SelfDisturbance self_disturbance(const ParticleView& particles,
                                                               const ParticleWeights& weights,
                                                               std::size_t p, double eps) {
  constexpr double crowded = 0.1;  // solids of others at which `alone` is 1 %
  const double volume = sphere_volume(particles.radius[p]);
  SelfDisturbance self;
  // No bell is narrower than a cell.
  if (1.0 - eps > crowded + volume / weights.cell_volume()) return self;
  self.footprint = weights.footprint(p);
  self.own_solids = own_solid_fraction(volume, self.footprint);
  self.alone = alone(1.0 - eps - self.own_solids);
  return self;
}

// K' = K / (1 - K R), K and R at the slip grown by the same factor.
template <class Law>
[[gnu::noinline]] double undisturbed(const Law& by_law, const GasProperties& gas,
                                     const SelfDisturbance& self, const Vec3& slip,
                                     DragRefresh& refresh) {
  constexpr int passes = 3;  // each leaves less than the share itself of the error before
  double growth = 1.0;
  double K = 0.0;
  bool cut = false;
  const DisturbancePerForce disturbance(gas, self.footprint, slip);
  const double speed = slip.norm();
  for (int pass = 0; pass < passes; ++pass) {
    K = by_law(growth);
    const double share = self.alone * K * disturbance.at(growth * speed);
    cut = share > greatest_share;
    growth = 1.0 / (1.0 - std::min(share, greatest_share));
  }
  if (cut) ++refresh.disturbance_cut;
  return K * growth;
}

}  // namespace

void deposit_solid_volume(const ParticleView& particles, const ParticleWeights& weights,
                          Array3<double>& solid_volume) {
  weights.deposit(
      [&](std::size_t p) { return particles.N(p) * sphere_volume(particles.radius[p]); },
      solid_volume);
}

void deposit_solids(const ParticleView& particles, const ParticleWeights& weights,
                    const Effects& effects, FieldStore& fields) {
  deposit_solid_volume(particles, weights, fields.scalar(GasField::solid_volume));
  if (effects.drag && effects.polydisperse)
    weights.deposit(
        [&](std::size_t p) { return particles.N(p) * sphere_surface(particles.radius[p]); },
        fields.scalar(GasField::solid_surface));
  if (effects.drag && effects.by_mean_velocity())
    weights.deposit(
        [&](std::size_t p) -> Vec3 {
          return particles.N(p) * sphere_volume(particles.radius[p]) * particles.v(p);
        },
        fields.vector(GasField::solid_flux));
}

DragRefresh refresh_drag(const ParticleView& particles, const ParticleWeights& weights,
                         const Effects& effects, const GasProperties& gas, const FieldStore& fields,
                         ExchangeRecords& records) {
  const bool by_mean = effects.drag && effects.by_mean_velocity();
  const RecordLayout& layout = records.layout();
  // The void fraction waits in K and the gas velocity in u until the law is evaluated.
  weights.sample(fields.scalar(GasField::void_fraction),
                 [&](std::size_t p, double eps) { records.K(p) = eps; });
  weights.sample(fields.vector(GasField::velocity),
                 [&](std::size_t p, const Vec3& u) { records.u(p) = u; });
  if (by_mean)
    weights.sample(fields.vector(GasField::solids_velocity),
                   [&](std::size_t p, const Vec3& v) { records.at(p, layout.mean_velocity) = v; });
  std::vector<double> sauter_diameter;
  if (effects.polydisperse) {
    sauter_diameter.resize(particles.count);
    weights.sample(fields.scalar(GasField::sauter_diameter),
                   [&](std::size_t p, double d) { sauter_diameter[p] = d; });
  }
  constexpr double round_off = 1e-9;  // cells filled to the gas's own limit are at the bound
  DragRefresh refresh;
  visit_apart(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        for (std::size_t p = 0; p < particles.count; ++p) {
          double eps = records.K(p);
          if (eps < least_drag_void_fraction - round_off) ++refresh.too_dense;
          refresh.least_void_fraction = std::min(refresh.least_void_fraction, eps);
          // The particles of a parcel are spread over its cells: none of them is alone there.
          const SelfDisturbance self =
              effects.ignore_self_disturbance || particles.parcel_size != nullptr
                  ? SelfDisturbance{}
                  : self_disturbance(particles, weights, p, eps);
          eps = std::clamp(eps + self.alone * self.own_solids, least_drag_void_fraction, 1.0);
          const auto coefficient = [&](const Vec3& v) __attribute__((always_inline)) {
            const Vec3 slip = records.u(p) - v;
            const auto by_law = [&](double growth) __attribute__((always_inline)) {
              const double d = 2.0 * particles.radius[p];
              const double speed = growth * slip.norm();
              const double K = effects.drag_factor *
                               (effects.polydisperse ? polydisperse_coefficient<Law>(
                                                           gas, eps, speed, d, sauter_diameter[p])
                                                     : Law::coefficient(gas, eps, speed, d));
              return gas.whole_pressure_gradient ? K / eps : K;
            };
            if (self.alone == 0.0) return by_law(1.0);
            return undisturbed(by_law, gas, self, slip, refresh);
          };
          records.K(p) = coefficient(particles.v(p));
          if (by_mean)
            records.row(p)[layout.mean_coefficient] =
                coefficient(records.at(p, layout.mean_velocity));
        }
      },
      *effects.drag);
  return refresh;
}

void deposit_drag(const ParticleView& particles, const ParticleWeights& weights,
                  const Effects& effects, double cell_volume, double interval, FieldStore& fields,
                  ExchangeRecords& records) {
  const double per_volume = 1.0 / cell_volume;
  const bool by_mean = effects.drag && effects.by_mean_velocity();
  // In scheme 1 gas and grains do not balance, and nothing is made up for.
  const double owed = by_mean && effects.own_drag() ? 0.0 : 1.0 / interval;
  if (effects.drag)
    weights.deposit(
        [&](std::size_t p) {
          return particles.N(p) * gas_coefficient(records, by_mean, p) * per_volume;
        },
        fields.scalar(GasField::drag_coefficient));
  weights.deposit(
      [&](std::size_t p) -> Vec3 {
        Vec3 source = -owed * records.carry(p);
        if (effects.drag)
          source += gas_coefficient(records, by_mean, p) *
                    gas_counterpart(particles, records, by_mean, p);
        return particles.N(p) * source * per_volume;
      },
      fields.vector(GasField::drag_source));
  for (std::size_t p = 0; p < particles.count; ++p) {
    records.expected(p) = -records.carry(p);
    records.taken(p).setZero();
  }
}

void book_expected(const ParticleView& particles, const ParticleWeights& weights,
                   const Effects& effects, const FieldStore& fields, double interval,
                   ExchangeRecords& records) {
  if (!effects.drag) return expect_nothing(particles, records);
  const bool by_mean = effects.by_mean_velocity();
  weights.sample(fields.vector(GasField::velocity), [&](std::size_t p, const Vec3& u) {
    expect(particles, by_mean, p, u, interval, records);
  });
}

void book_expected(const ParticleView& particles, const Effects& effects, double interval,
                   ExchangeRecords& records) {
  if (!effects.drag) return expect_nothing(particles, records);
  const bool by_mean = effects.by_mean_velocity();
  for (std::size_t p = 0; p < particles.count; ++p)
    expect(particles, by_mean, p, records.u(p), interval, records);
}

std::vector<double> set_gas_at_particles(const ParticleView& particles,
                                         const ParticleWeights& weights, const Effects& effects,
                                         const GasProperties& gas, const FieldStore& fields,
                                         double interval, ExchangeRecords& records,
                                         std::vector<double>* seconds) {
  const RecordLayout& layout = records.layout();
  if (seconds != nullptr) seconds->assign(effects.names().size(), 0.0);
  const auto sample = [&](GasField field, auto&& put) {
    if (effects.lent().has(field)) weights.sample(fields.vector(field), put);
  };
  sample(GasField::velocity, [&](std::size_t p, const Vec3& u) { records.u(p) = u; });
  sample(GasField::vorticity,
         [&](std::size_t p, const Vec3& w) { records.at(p, layout.vorticity) = w; });
  sample(GasField::acceleration,
         [&](std::size_t p, const Vec3& a) { records.at(p, layout.acceleration) = a; });
  for (std::size_t p = 0; p < particles.count; ++p) {
    records.steady_force(p).setZero();
    if (layout.reaction >= 0) records.at(p, layout.reaction).setZero();
  }
  std::vector<double> work(effects.names().size(), 0.0);
  std::size_t n = effects.drag ? 1 : 0;
  for (const Force& force : effects.forces) {
    visit_apart(
        [&](const auto& chosen) {
          using Chosen = std::decay_t<decltype(chosen)>;
          if constexpr (Chosen::kind == ForceKind::steady) {
            const WallClock clock;
            work[n] = interval * add_steady<Chosen>(particles, weights, gas, fields, records);
            if (seconds != nullptr) (*seconds)[n] = clock.seconds();
          }
        },
        force);
    ++n;
  }
  if (effects.drag && !effects.own_drag())
    for (std::size_t p = 0; p < particles.count; ++p) {
      const Vec3 force = gas_coefficient(records, true, p) *
                         (records.u(p) - gas_counterpart(particles, records, true, p));
      records.steady_force(p) += force;
      records.at(p, layout.reaction) += force;
      work[0] += particles.N(p) * interval * force.lpNorm<1>();
    }
  return work;
}

Vec3 outstanding_carry(const ParticleView& particles, const ExchangeRecords& records) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t p = 0; p < particles.count; ++p) sum += particles.N(p) * records.carry(p);
  return sum;
}

}  // namespace gasgrain
