// Magnus force: lift on a particle that spins otherwise than the gas turns, across its slip.
//
//   F = pi/8 d^2 rho C |u - v| Omega x (u - v) / |Omega|,   Omega = curl u / 2 - omega_p
//   C = 0.4 min(1, G),   G = d |Omega| / (2 |u - v|)
// hence
//   F = pi/8 d^2 rho 0.4 min(d/2, |u - v| / |Omega|) Omega x (u - v)
//
// A particle that flies with backspin is lifted.
//
// Source: Y. Tsuji, Y. Morikawa, O. Mizuno, J. Fluids Eng. 107 (1985) 484: C = (0.4 +- 0.1) G;
//   Alobaid (2013), eqs 5.24 to 5.26.
// Inputs: density, u, curl u [1/s], v, omega_p [rad/s], radius. Output: force on the particle [N].
// Assumptions: the slip is the interstitial one; a sphere alone.
// Range: Re = rho |u - v| d / mu of 550 to 1600 and G to 0.7, as measured. In creeping flow the
// force
//   is five times this one: S.I. Rubinow, J.B. Keller, J. Fluid Mech. 11 (1961) 447, C = 2 G.
// Deviations: eq 5.24 multiplies (u - v) by Omega in this order, which turns the force round: for a
//   sphere that moves with V and spins with omega_p in gas at rest, Rubinow and Keller have F =
//   pi (d/2)^3 rho omega_p x V. G is that of the thesis (eq 5.26), with d/2.
#pragma once

#include <Eigen/Geometry>
#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/gas_at_particle.h"

namespace gasgrain {

struct ForceMagnus {
  static constexpr std::string_view name = "magnus";
  static constexpr ForceKind kind = ForceKind::motion;
  static constexpr bool reacts = true;

  static constexpr FieldSet lent() {
    return FieldSet().add(GasField::velocity).add(GasField::vorticity);
  }

  Vec3 force(const GasProperties& gas, const GasAtParticle& at, const GrainState& grain) const {
    constexpr double lift = 0.4;
    const Vec3 slip = at.velocity - grain.velocity;
    const Vec3 turn = 0.5 * at.vorticity - grain.angular_velocity;
    const double speed = slip.norm();
    const double rate = turn.norm();
    const bool slow_spin = grain.radius * rate <= speed;  // G <= 1
    const double length = slow_spin ? grain.radius : speed / rate;
    const double area = pi * grain.radius * grain.radius;
    return 0.5 * area * gas.density * lift * length * turn.cross(slip);
  }
};

}  // namespace gasgrain
