// A source of parcels: the list of parcels that come in during a step.
//
// Parcel k carries the mass m_k: N particles of its radius, or an even share of the flow. It enters
// at the time t_k at which the flow has brought all of it,
//
//   mass_flow (t_k - from) = m_0 + ... + m_k
//
// and is placed where it has come to since, v (t + dt - t_k) from the opening: steps leave no
// gaps and no clumps. Positions in the opening follow a sequence of low discrepancy (additive
// recurrence with the powers of 1/1.3247..., root of x^3 = x + 1), radii and directions a hash of
// the seed and k (counter_random.h). What has not come in whole is carried over:
// injected + carried = mass_flow * time to round-off; at the time `to` the rest comes as a parcel
// of fewer particles.
// The list depends on nothing but the settings, the state and the times: it is the same on every
// rank, and the host takes those that fall into its part.
#pragma once

#include <vector>

#include "fix_cfd_coupling/dem_physics/parcels/injection_settings.h"

namespace gasgrain {

struct NewParcel {
  Vec3 position;                  // at the end of the step [m]
  Vec3 velocity;                  // [m/s]
  double radius;                  // of a particle, film included [m]
  double solid_volume;            // of a particle [m3]
  double solid_mass;              // of a particle [kg]
  std::vector<double> film_mass;  // of a particle, each species [kg]
  double particles;               // N_p
  int type;
};

// What has come in so far [kg].
struct InjectionAccount {
  double flow = 0.0;            // of the liquid of droplets, or the solids
  double solids = 0.0;          // solid mass, cores of droplets included
  std::vector<double> species;  // liquid
  double particles = 0.0;
  double parcels = 0.0;
};

class Injector {
 public:
  // box: of the run (for a face). Throws Error where the face's rectangle is not on it.
  Injector(const InjectionSettings& settings, const BoxGrid& box);

  // Parcels that enter from `time` to `time + dt`. Steps follow each other without gaps.
  std::vector<NewParcel> due(double time, double dt);

  [[nodiscard]] double mass_flow() const { return mass_flow_; }  // [kg/s]
  [[nodiscard]] const InjectionAccount& account() const { return account_; }
  // Mass that the flow has brought by `time` and that has not come in yet [kg].
  [[nodiscard]] double carried(double time) const;

  // For restarts; always the same length.
  [[nodiscard]] std::vector<double> state() const;
  void set_state(const std::vector<double>& state);

 private:
  [[nodiscard]] double brought(double time) const;
  [[nodiscard]] double particle_mass(double radius) const;  // of the flow [kg]
  [[nodiscard]] NewParcel make(double radius, double particles, double since) const;
  void take_into_account(const NewParcel& parcel, double mass);

  InjectionSettings settings_;
  BoxGrid box_;
  double mass_flow_ = 0.0;
  Vec3 across_[2];              // of the disc or the rectangle, [m] each
  Vec3 origin_ = Vec3::Zero();  // centre of the disc or corner of the rectangle
  double correction_ = 0.0;     // of account_.flow: what its last digits lost
  InjectionAccount account_;
};

}  // namespace gasgrain
