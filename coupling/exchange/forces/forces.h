// The LIST of steady forces: those of the gas on a particle that do not depend on the particle's
// velocity, and so hold for a whole coupling interval. A new one is a header beside the others and
// a line here. A force is a struct with `name`, `lent()`, the gas fields it needs, and
//   static Vec3 force(const GasAtParticle&, double radius)   [N]
#pragma once

#include <variant>

#include "coupling/exchange/choice_list.h"
#include "coupling/exchange/forces/pressure_gradient.h"

namespace gasgrain {

using SteadyForce = std::variant<ForcePressureGradient>;

}  // namespace gasgrain
