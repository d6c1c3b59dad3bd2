// The gap at which a bridge breaks, for laws without a criterion of their own.
//
//   s_c = (1 + theta / 2) V^(1/3)
//
// Source: Lian, Thornton and Adams, J. Colloid Interface Sci. 161 (1993) 138: fitted to the gap
//   beyond which the Young-Laplace equation has no solution.
// Inputs: V [m3], theta [rad]; output s_c [m]. The same for unequal grains and walls.
// Range: theta to 40 degrees; from V / R^3 = 1e-4 to 0.01 the solutions for two grains end at 0.97
//   to 1.03 of it (tests/bridges/young_laplace.cpp). Quasi-static: a viscous bridge pulled fast is
//   longer.
#pragma once

#include <cmath>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

inline double lian_rupture_distance(const LiquidBridge& b) {
  return (1.0 + 0.5 * b.contact_angle) * std::cbrt(b.volume);
}

}  // namespace gasgrain::bridge
