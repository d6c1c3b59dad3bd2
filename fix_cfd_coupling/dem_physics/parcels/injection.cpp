#include "fix_cfd_coupling/dem_physics/parcels/injection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/parcels/counter_random.h"

namespace gasgrain {

namespace {

double sphere(double radius) {
  return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

// Member k of the additive recurrence along one of two axes, from 0 to 1.
double spread_evenly(double k, int axis) {
  constexpr double root = 1.3247179572447460;  // of x^3 = x + 1
  const double step = axis == 0 ? 1.0 / root : 1.0 / (root * root);
  const double at = 0.5 + std::fmod(k, 0x1p40) * step;
  return at - std::floor(at);
}

// Two vectors of length 1 across a direction.
std::array<Vec3, 2> across_of(const Vec3& direction) {
  int least = 0;
  for (int d = 1; d < 3; ++d)
    if (std::abs(direction[d]) < std::abs(direction[least])) least = d;
  const Vec3 first = direction.cross(Vec3::Unit(least)).normalized();
  return {first, direction.cross(first)};
}

// Adds to a sum and keeps in `correction` what its last digits lose (Neumaier's summation).
void add_exactly(double& sum, double& correction, double value) {
  const double next = sum + value;
  correction += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
  sum = next;
}

}  // namespace

Injector::Injector(const InjectionSettings& settings, const BoxGrid& box)
    : settings_(settings), box_(box), mass_flow_(settings.mass_flow) {
  account_.species.assign(settings.mass_fraction.size(), 0.0);
  if (!settings_.of_face()) {
    const auto across = across_of(settings_.direction);
    for (int n = 0; n < 2; ++n) across_[n] = settings_.nozzle_radius * across[n];
    origin_ = settings_.at;
    return;
  }
  const int normal = settings_.face_axis;
  settings_.direction = (settings_.face_high ? -1.0 : 1.0) * Vec3::Unit(normal);
  origin_[normal] = settings_.face_high ? box.hi[normal] : box.lo[normal];
  for (int n = 0; n < 2; ++n) {
    const int axis = n == 0 ? (normal == 0 ? 1 : 0) : (normal == 2 ? 1 : 2);
    double low = box.lo[axis];
    double high = box.hi[axis];
    if (settings_.rectangle) {
      low = (*settings_.rectangle)[2 * n];
      high = (*settings_.rectangle)[2 * n + 1];
      if (!(low >= box.lo[axis] && high <= box.hi[axis] && low < high))
        fail(
            "rectangle {:.6g} to {:.6g} m along {} is not on the side of the box, which goes from "
            "{:.6g} to {:.6g} m: leave it out for all of the side, or keep it within.",
            low, high, "xyz"[axis], box.lo[axis], box.hi[axis]);
    }
    origin_[axis] = low;
    across_[n] = (high - low) * Vec3::Unit(axis);
  }
  const double area = across_[0].norm() * across_[1].norm();
  mass_flow_ = settings_.fraction * settings_.density * settings_.speed * area;
}

double Injector::brought(double time) const {
  return mass_flow_ * std::clamp(time - settings_.from, 0.0, settings_.to - settings_.from);
}

double Injector::carried(double time) const {
  return (brought(time) - account_.flow) - correction_;
}

double Injector::particle_mass(double radius) const {
  const double core = settings_.liquid ? sphere(settings_.core_radius) : 0.0;
  return settings_.density * (sphere(radius) - core);
}

NewParcel Injector::make(double radius, double particles, double since) const {
  const double k = account_.parcels;
  CounterRandom random(settings_.seed, 0x70617263656c73, static_cast<std::uint64_t>(k));
  random.uniform();  // the radius
  const double a = spread_evenly(k, 0);
  const double b = spread_evenly(k, 1);
  Vec3 direction = settings_.direction;
  Vec3 opening = origin_;
  if (settings_.of_face()) {
    opening += a * across_[0] + b * across_[1];
  } else {
    const double r = std::sqrt(a);
    opening += r * (std::cos(2.0 * M_PI * b) * across_[0] + std::sin(2.0 * M_PI * b) * across_[1]);
    const double cosine = 1.0 - random.uniform() * (1.0 - std::cos(settings_.half_angle));
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double around = 2.0 * M_PI * random.uniform();
    const auto across = across_of(settings_.direction);
    direction = cosine * settings_.direction +
                sine * (std::cos(around) * across[0] + std::sin(around) * across[1]);
  }
  NewParcel parcel;
  parcel.velocity = settings_.speed * direction;
  parcel.position = opening + since * parcel.velocity;
  parcel.radius = radius;
  parcel.film_mass.assign(settings_.mass_fraction.size(), 0.0);
  if (settings_.liquid) {
    parcel.solid_volume = sphere(settings_.core_radius);
    parcel.solid_mass = settings_.core_density * parcel.solid_volume;
    const double mass = particle_mass(radius);
    for (std::size_t s = 0; s < parcel.film_mass.size(); ++s)
      parcel.film_mass[s] = settings_.mass_fraction[s] * mass;
  } else {
    parcel.solid_volume = sphere(radius);
    parcel.solid_mass = particle_mass(radius);
  }
  parcel.particles = particles;
  parcel.type = settings_.type;
  return parcel;
}

void Injector::take_into_account(const NewParcel& parcel, double mass) {
  add_exactly(account_.flow, correction_, mass);
  account_.solids += parcel.particles * parcel.solid_mass;
  for (std::size_t s = 0; s < account_.species.size(); ++s)
    account_.species[s] += parcel.particles * parcel.film_mass[s];
  account_.particles += parcel.particles;
  account_.parcels += 1.0;
}

std::vector<NewParcel> Injector::due(double time, double dt) {
  std::vector<NewParcel> list;
  const double end = time + dt;
  if (mass_flow_ <= 0.0 || end <= settings_.from) return list;
  const double share = mass_flow_ / settings_.number * (settings_.by == ParcelsBy::step ? dt : 1.0);
  for (double left = carried(end); left > 0.0; left = carried(end)) {
    CounterRandom random(settings_.seed, 0x70617263656c73,
                         static_cast<std::uint64_t>(account_.parcels));
    const double radius = settings_.size.quantile(random.uniform());
    const double of_particle = particle_mass(radius);
    double mass = settings_.by == ParcelsBy::particles ? settings_.number * of_particle : share;
    // A parcel that lacks no more than round-off is whole.
    const bool whole = mass <= left * (1.0 + 1e-9);
    const bool last = end >= settings_.to;
    if (!whole && !last) break;
    if (mass > left) {
      // The end of the flow, or round-off.
      if (last && left < 1e-12 * mass) break;
      mass = left;
    }
    // How long before the step's end the flow had brought it.
    const double since = (left - mass) / mass_flow_ + std::max(0.0, end - settings_.to);
    const NewParcel parcel = make(radius, mass / of_particle, since);
    take_into_account(parcel, mass);
    list.push_back(parcel);
  }
  return list;
}

std::vector<double> Injector::state() const {
  std::vector<double> state{account_.flow, correction_, account_.solids, account_.particles,
                            account_.parcels};
  state.insert(state.end(), account_.species.begin(), account_.species.end());
  return state;
}

void Injector::set_state(const std::vector<double>& state) {
  if (state.size() != 5 + account_.species.size())
    fail(
        "the restart holds {} numbers of an injection where this one has {}: it was written by a "
        "run with other liquid species.",
        state.size(), 5 + account_.species.size());
  account_.flow = state[0];
  correction_ = state[1];
  account_.solids = state[2];
  account_.particles = state[3];
  account_.parcels = state[4];
  std::copy(state.begin() + 5, state.end(), account_.species.begin());
}

}  // namespace gasgrain
