// Capillary force of small bridges, the closed form of Willett et al.
//
//   F = 2 pi R gamma cos theta / (1 + 2.1 S + 10 S^2),   S = (s / 2) / (V / R)^(1/2)
//   rupture at s / R = (1 + theta / 2) (v^(1/3) + v^(2/3) / 10),   v = V / R^3
//
// Source: Willett, Adams, Johnson and Seville, Langmuir 16 (2000) 9396: the approximation for small
//   volumes, and the rupture distance of equal spheres.
// Inputs, output: bridges.h.
// Range: v below 1e-3, theta to 20 degrees: within 10 % of the Young-Laplace equation up to 0.3 of
//   the rupture distance, 0.78 to 0.9 of it near rupture. At v = 0.05 the contact force is 1.2
//   times it; at 40 degrees the tail is half of it. F depends on V through S alone, so that it has
//   the right limit 2 pi R gamma cos theta and no smallest volume.
// Deviations: unequal radii by Derjaguin's, also in the rupture distance, for which the paper
//   has a correction of its own. willett_fit.h has the paper's fit for larger volumes and angles.
#pragma once

#include <cmath>
#include <string_view>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

struct BridgeWillett {
  static constexpr std::string_view name = "willett";
  static constexpr std::string_view source = "Willett, Adams, Johnson and Seville (2000)";
  static constexpr BridgeRange range{0.0, 1e-3, 0.35};

  static double force(const LiquidBridge& b, double gap) {
    const double s = scaled_half_gap(b, gap);
    return contact_force(b) / (1.0 + s * (2.1 + 10.0 * s));
  }

  static double rupture_distance(const LiquidBridge& b) {
    const double cube_root = std::cbrt(scaled_volume(b));
    return b.radius * (1.0 + 0.5 * b.contact_angle) * cube_root * (1.0 + 0.1 * cube_root);
  }

  static double scaled_half_gap(const LiquidBridge& b, double gap) {
    return 0.5 * gap * std::sqrt(b.radius / b.volume);
  }
  static double scaled_volume(const LiquidBridge& b) { return reduced_volume(b); }
};

}  // namespace gasgrain::bridge
