// Capillary force as the derivative of the bridge's surface energy, for a bridge that is a flat
// cylinder between parabolic caps.
//
//   d = (V / (pi R)) / (s + (s^2 + 2 V / (pi R))^(1/2))      depth of immersion of either grain [m]
//   F = 2 pi R gamma cos theta / (1 + s / (2 d))
//
// Source: Rabinovich, Esayanur and Moudgil, Langmuir 21 (2005) 10992, the first term of the force
//   of two spheres; Lambert, Chau, Delchambre and Regnier, Langmuir 24 (2008) 3157, who show
//   that it is the whole force: the energy already holds the pull of the contact line.
// Inputs, output: bridges.h. Rupture: rupture.h.
// Range: V / R^3 below 1e-3, theta to 20 degrees: within 13 % of the Young-Laplace equation up to
//   0.3 of the rupture distance, 0.7 of it near rupture. No smallest volume.
// Deviations: d is written for any gap, s = 0 included, where the paper's
//   (s / 2) (-1 + (1 + 2 V / (pi R s^2))^(1/2)) is infinite times 0.
#pragma once

#include <cmath>
#include <string_view>

#include "fix_cfd_coupling/dem_physics/bridge/rupture.h"

namespace gasgrain::bridge {

struct BridgeRabinovichEnergy {
  static constexpr std::string_view name = "rabinovich_energy";
  static constexpr std::string_view source = "Rabinovich et al. (2005), Lambert et al. (2008)";
  static constexpr BridgeRange range{0.0, 1e-3, 0.35};

  static double force(const LiquidBridge& b, double gap) {
    return contact_force(b) / (1.0 + gap / (2.0 * immersion(b, gap)));
  }
  static double immersion(const LiquidBridge& b, double gap) {
    const double q = b.volume / (pi * b.radius);
    return q / (gap + std::sqrt(gap * gap + 2.0 * q));
  }

  static double rupture_distance(const LiquidBridge& b) { return lian_rupture_distance(b); }
  static double scaled_volume(const LiquidBridge& b) { return reduced_volume(b); }
};

}  // namespace gasgrain::bridge
