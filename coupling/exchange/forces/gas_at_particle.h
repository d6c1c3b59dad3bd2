// What the steady forces may know of the gas where a particle is; a force names the fields it needs
// in its lent(), and only those are filled in.
#pragma once

#include "coupling/base/vec3.h"
#include "coupling/exchange/gas_fields.h"

namespace gasgrain {

struct GasAtParticle {
  Vec3 pressure_gradient = Vec3::Zero();  // [Pa/m]
};

}  // namespace gasgrain
