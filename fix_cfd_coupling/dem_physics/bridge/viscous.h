// Viscous resistance of a liquid bridge: lubrication between the two surfaces.
//
//   normal      F_n = -3/2 pi mu R^2 X^2 v_n / s
//   tangential  F_t = -3 pi mu R (8/15 ln(R / (2 s)) + 0.9588) v_t
//   s = max(gap, minimum separation),   X = 1 - s / (s^2 + 2 V / (pi R))^(1/2)
//
// Source: normal, of grains immersed (X = 1): Adams and Perchard, Inst. Chem. Eng. Symp. Ser. 91
//   (1985) 147; X, of a bridge of finite volume: Pitois, Moucheront and Chateau, J. Colloid
//   Interface Sci. 231 (2000) 26. Tangential, a sphere along a wall: Goldman, Cox and Brenner,
//   Chem. Eng. Sci. 22 (1967) 637; with the pair's reduced radius R / 2 for the sphere's: Lian,
//   Thornton and Adams, Chem. Eng. Sci. 53 (1998) 3381.
// Inputs: mu [Pa s], gap and minimum separation [m] (that of roughness, > 0), v_n, v_t relative
//   velocities of the surfaces [m/s]. Outputs: coefficients c of F = -c v [N s/m], never negative.
// Assumes: Reynolds number of the film << 1, s << R, Newtonian liquid. The force of rotation about
//   the line of centres is left out. The tangential law has no volume: it supposes that the bridge
//   is wider than (R s)^(1/2).
// Deviations: where the logarithm would make the tangential coefficient negative (s > 3 R, longer
//   than any bridge) it is 0.
#pragma once

#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

inline double viscous_normal(const LiquidBridge& b, double viscosity, double gap,
                             double minimum_separation) {
  if (!(b.volume > 0.0)) return 0.0;
  const double s = std::max(gap, minimum_separation);
  const double root = std::sqrt(s * s + 2.0 * b.volume / (pi * b.radius));
  // 1 - s / root without the loss of digits of a small volume
  const double x = 2.0 * b.volume / (pi * b.radius) / (root * (root + s));
  return 1.5 * pi * viscosity * b.radius * b.radius * x * x / s;
}

inline double viscous_tangential(const LiquidBridge& b, double viscosity, double gap,
                                 double minimum_separation) {
  if (!(b.volume > 0.0)) return 0.0;
  const double s = std::max(gap, minimum_separation);
  const double reduced = 0.5 * b.radius;
  const double resistance = 8.0 / 15.0 * std::log(reduced / s) + 0.9588;
  return 6.0 * pi * viscosity * reduced * std::max(resistance, 0.0);
}

}  // namespace gasgrain::bridge
