// Force of the gas pressure on a particle, buoyancy included, as the pressure varies little over
// it.
//
//   F = -V_p grad p
//
// Source: B.P.B. Hoomans et al., Powder Technol. 116 (2001) 166, eq 26 (third term).
// Inputs: radius [m], grad p [Pa/m] (three components). Output: force on the particle [N].
// Assumptions: model A: the gas keeps eps grad p in its own balance, and nothing is given back for
//   this force. p is the full pressure; where it is measured from is of no matter, whether it
//   contains the gas's weight is (the gas solver's choice).
// Range: particles small against the length over which grad p varies. Deviation: none.
#pragma once

#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/gas_at_particle.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct ForcePressureGradient {
  static constexpr std::string_view name = "pressure_gradient";
  static constexpr ForceKind kind = ForceKind::steady;
  static constexpr bool reacts = false;

  static constexpr FieldSet lent() { return FieldSet().add(GasField::pressure_gradient); }

  static Vec3 force(const GasProperties& /*gas*/, const GasAtParticle& at, double radius) {
    return -sphere_volume(radius) * at.pressure_gradient;
  }
};

}  // namespace gasgrain
