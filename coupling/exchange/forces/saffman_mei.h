// Lift on a particle that slips through sheared gas.
//
//   F = 1.615 d^2 (rho mu |omega|)^(1/2) f (u - v) x omega / |omega|,   omega = curl u
//   f = e^(-Re/10) + alpha (1 - e^(-Re/10))   Re <= 40
//   f = 0.0524 (beta Re)^(1/2)                Re > 40
//   Re = rho |u - v| d / mu,   beta = d |omega| / (2 |u - v|),   alpha = 0.3314 beta^(1/2)
//
// A particle slower than the gas is driven towards the faster gas.
//
// Source: P.G. Saffman, J. Fluid Mech. 22 (1965) 385, with the corrigendum 31 (1968) 624: 6.46 for
//   the radius squared, 1.615 for d^2. f: R. Mei, Int. J. Multiphase Flow 18 (1992) 145.
// Inputs: density, viscosity, u, omega [1/s], v, radius. Output: force on the particle [N].
// Assumptions: the slip is the interstitial one; a sphere alone, far from walls; omega is the
// gas's,
//   the particle's own spin is left to magnus.h.
// Range: Mei's data are of Re 0.1 to 100, beta 0.005 to 0.4. Saffman's limit, f = 1, needs Re much
//   below (rho d^2 |omega| / mu)^(1/2) and that much below 1.
// As published f jumps at Re = 40, by 0.0183 (1 - alpha): down to 0.57 of itself at beta = 0.005,
// to
//   0.86 at 0.1, to 0.94 at 0.4.
// Deviations: from Alobaid (2013), whose eq 5.18 has a factor pi too many; eq 5.19 halves omega,
//   which belongs to the particle's rotation and makes F smaller by 2^(1/2); eq 5.20 takes the
//   particle's spin into Re_s (Mei: rho d^2 |omega| / mu); eq 5.21 has exp(+Re/10), which grows to
//   55 at Re = 40. Its second branch is Mei's, beta Re being Re_s / 2. Eq 5.17 lacks the root of
//   the velocity gradient.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string_view>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"
#include "coupling/exchange/forces/force_kind.h"
#include "coupling/exchange/forces/gas_at_particle.h"

namespace gasgrain {

struct ForceSaffmanMei {
  static constexpr std::string_view name = "saffman_mei";
  static constexpr ForceKind kind = ForceKind::motion;
  static constexpr bool reacts = true;

  static constexpr FieldSet lent() {
    return FieldSet().add(GasField::velocity).add(GasField::vorticity);
  }

  Vec3 force(const GasProperties& gas, const GasAtParticle& at, const GrainState& grain) const {
    const Vec3 slip = at.velocity - grain.velocity;
    const double speed = slip.norm();
    const double vorticity = at.vorticity.norm();
    if (speed == 0.0 || vorticity == 0.0) return Vec3::Zero();
    const double d = 2.0 * grain.radius;
    const double f =
        over_saffman(interstitial_reynolds(gas, speed, d), 0.5 * d * vorticity / speed);
    return 1.615 * d * d * f * std::sqrt(gas.density * gas.viscosity * vorticity) *
           slip.cross(at.vorticity / vorticity);
  }

  // Mei's f.
  static double over_saffman(double re, double beta) {
    constexpr double re_switch = 40.0;
    if (re > re_switch) return 0.0524 * std::sqrt(beta * re);
    return std::exp(-0.1 * re) - 0.3314 * std::sqrt(beta) * std::expm1(-0.1 * re);
  }
};

}  // namespace gasgrain
