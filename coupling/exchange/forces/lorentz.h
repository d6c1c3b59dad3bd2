// Force of uniform electric and magnetic fields on a charged particle.
//
//   F = q (E + v x B)
//
// Source: Alobaid (2013), eqs 5.4 and 5.6.
// Inputs: v [m/s]; the members: charge q of every particle [C], E [V/m], B [T], all constant.
//   Output: force on the particle [N].
// Assumptions: the charge stays; particles do not act on each other, nor on the fields. v is that
//   seen by whoever measures E and B, so that this force alone is not Galilean invariant. It comes
//   from outside: the gas gives nothing.
// Range: speeds far below that of light; |q B| dt / m << 1, v x B being taken explicitly.
// Deviations: eq 5.5, the force on a particle with magnetic poles of its own, is left out: printed
// as
//   n eps B it has no unit of a force for a uniform field, where poles feel a torque only.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/force_parameter.h"
#include "coupling/exchange/forces/gas_at_particle.h"

namespace gasgrain {

struct ForceLorentz {
  static constexpr std::string_view name = "lorentz";
  static constexpr ForceKind kind = ForceKind::motion;
  static constexpr bool reacts = false;

  static constexpr FieldSet lent() { return {}; }

  Vec3 force(const GasProperties& /*gas*/, const GasAtParticle& /*at*/,
             const GrainState& grain) const {
    return charge * (electric + grain.velocity.cross(magnetic));
  }

  // `lorentz charge Q electric Ex Ey Ez magnetic Bx By Bz`
  static constexpr std::array<ForceParameter, 3> parameters{{
      {"charge", 1, "C"},
      {"electric", 3, "V/m"},
      {"magnetic", 3, "T"},
  }};

  // Where the values of parameters[n] go; as many as it says.
  double* values(std::size_t n) {
    return n == 0 ? &charge : (n == 1 ? electric.data() : magnetic.data());
  }

  double charge = 0.0;           // q [C]
  Vec3 electric = Vec3::Zero();  // E [V/m]
  Vec3 magnetic = Vec3::Zero();  // B [T]
};

}  // namespace gasgrain
