// Torque of the gas on a particle that spins otherwise than the gas turns.
//
//   T = 1/64 rho d^5 C |Omega| Omega,   Omega = curl u / 2 - omega_p,   R = rho d^2 |Omega| / (4
//   mu) C R = max(16 pi, 6.45 R^(1/2) + 32.1, 6.8 R^(1/2))       laminar C   = max(laminar,
//   min(0.058 R^(-1/20), 0.397 R^(-1/5)))
// With C R for R -> 0 this is Stokes' torque, T = pi mu d^3 Omega.
//
// Source: S.C.R. Dennis, S.N. Singh, D.B. Ingham, J. Fluid Mech. 101 (1980) 257 (the second line to
//   R = 1000; R is formed with the radius, for the diameter it reads 12.9 Re^(-1/2) + 128.4 / Re);
//   the rest as in Alobaid (2013), eqs 5.105 to 5.108, after O. Sawatzki, Acta Mech. 9 (1970) 159.
// Inputs: density, viscosity, curl u [1/s], omega_p [rad/s], radius. Output: torque on the particle
//   about its centre [N m].
// Assumptions: a sphere alone; slip changes nothing. The gas keeps its angular momentum: what
//   the torque takes is not given back.
// Range: R to 1e7.
// Deviations from the thesis: it changes from the first form to the second at R = 10, where C jumps
//   up by 4 %; here the greater of two neighbours holds, which is continuous (changes at R = 7.93,
//   8411, 3.96e4 and 3.7e5). Its third form, 6.8 R^(-1/20), would be 20 times its neighbours; with
//   the power -1/2 it meets them. Eq 5.105 takes Stokes' torque where the Reynolds number of the
//   SLIP is below 1; the torque here is that of the spin alone, whose small R is Stokes' anyway.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/gas_at_particle.h"

namespace gasgrain {

struct ForceRotationTorque {
  static constexpr std::string_view name = "rotation_torque";
  static constexpr ForceKind kind = ForceKind::torque;
  static constexpr bool reacts = false;

  static constexpr FieldSet lent() { return FieldSet().add(GasField::vorticity); }

  Vec3 torque(const GasProperties& gas, const GasAtParticle& at, const GrainState& grain) const {
    const Vec3 turn = 0.5 * at.vorticity - grain.angular_velocity;
    const double d = 2.0 * grain.radius;
    const double re = 0.25 * gas.density * d * d * turn.norm() / gas.viscosity;
    return 0.0625 * gas.viscosity * d * d * d * coefficient_by_re(re) * turn;
  }

  // C R, which R = 0 does not make infinite.
  static double coefficient_by_re(double re) {
    constexpr double turbulent_above = 1e4;  // below it the turbulent forms are the smaller
    const double root = std::sqrt(re);
    const double laminar = std::max({16.0 * pi, 6.45 * root + 32.1, 6.8 * root});
    if (re < turbulent_above) return laminar;
    const double turbulent = std::min(0.058 * std::pow(re, 0.95), 0.397 * std::pow(re, 0.8));
    return std::max(laminar, turbulent);
  }
};

}  // namespace gasgrain
