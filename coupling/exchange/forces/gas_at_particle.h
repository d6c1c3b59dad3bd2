// What forces may know: of the gas where a particle is, and of the particle. A force names the gas
// fields it needs in its lent(); only those are filled in.
#pragma once

#include "coupling/base/vec3.h"
#include "coupling/exchange/gas_fields.h"

namespace gasgrain {

struct GasAtParticle {
  Vec3 velocity = Vec3::Zero();           // u, interstitial [m/s]
  Vec3 pressure_gradient = Vec3::Zero();  // grad p [Pa/m]
  Vec3 vorticity = Vec3::Zero();          // curl u [1/s]
  Vec3 acceleration = Vec3::Zero();       // Du/Dt, along the gas's own path [m/s2]
  Vec3 viscous_force = Vec3::Zero();      // div tau [N/m3]
};

// Where a lent field of the gas has its place.
inline Vec3& place(GasAtParticle& at, GasField field) {
  switch (field) {
    case GasField::pressure_gradient:
      return at.pressure_gradient;
    case GasField::vorticity:
      return at.vorticity;
    case GasField::acceleration:
      return at.acceleration;
    case GasField::viscous_force:
      return at.viscous_force;
    default:
      return at.velocity;
  }
}

struct GrainState {
  Vec3 velocity = Vec3::Zero();          // [m/s]
  Vec3 angular_velocity = Vec3::Zero();  // [rad/s]
  double radius = 0.0;                   // [m]
};

}  // namespace gasgrain
