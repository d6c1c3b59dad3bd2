// Force of the gas's own viscous stress on a particle, as far as the stress would act on gas in its
// place.
//
//   F = V_p div tau,   tau = mu (grad u + grad u^T - 2/3 div u)
//
// Source: M.R. Maxey, J.J. Riley, Phys. Fluids 26 (1983) 883: the force of the undisturbed flow,
//   V_p (-grad p + div tau); the other half is pressure_gradient.h.
// Inputs: radius [m], div tau [N/m3]. Output: force on the particle [N].
// Assumptions: the gas has div(eps tau) in its balance and loses V_p div tau per particle. The
// stress
//   is that of the mean flow between particles, with the molecular viscosity: what turbulence adds
//   is the mean of fluctuations, which are not felt as a steady force.
// Range: particles small against the length over which tau varies.
// Deviations: in the thesis of Alobaid (2013) this force is missing; beside pressure gradients in
//   gas it is small.
#pragma once

#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/gas_at_particle.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct ForceViscousStress {
  static constexpr std::string_view name = "viscous_stress";
  static constexpr ForceKind kind = ForceKind::steady;
  static constexpr bool reacts = true;

  static constexpr FieldSet lent() { return FieldSet().add(GasField::viscous_force); }

  static Vec3 force(const GasProperties& /*gas*/, const GasAtParticle& at, double radius) {
    return sphere_volume(radius) * at.viscous_force;
  }
};

}  // namespace gasgrain
