// Capillary force of a toroidal bridge, taken at its neck (the gorge method).
//
//   F = 2 pi R2 gamma + pi R2^2 gamma (1 / R1 - 1 / R2) = pi gamma R2 (1 + R2 / R1)
// with the toroid (toroid.h) whose volume is V; 1 / R1 - 1 / R2 is the suction at the neck.
//
// Source: Lian, Thornton and Adams, J. Colloid Interface Sci. 161 (1993) 138; Alobaid (2013), 5.67.
// Inputs, output: bridges.h. Rupture: rupture.h.
// Range: V / R^3 to 0.1, theta to 40 degrees: within 7 % of the Young-Laplace equation for grains
// up
//   to 0.9 of the rupture distance, and for walls except 16 % at 0.9 of it, V / r^3 = 0.01. No
//   smallest volume.
// Deviations: eq 5.67 takes the force at the grain, 2 pi R gamma sin beta sin(beta + theta) + pi
//   (R sin beta)^2 dp. On a true meridian both are the same; on a toroid, whose pressure is not
//   uniform, that one falls to 0.15 of the true force near rupture where the neck's stays within
//   7 %.
// Cost: the filling angle of a volume is found by iteration.
#pragma once

#include <string_view>

#include "fix_cfd_coupling/dem_physics/bridge/rupture.h"
#include "fix_cfd_coupling/dem_physics/bridge/toroid.h"

namespace gasgrain::bridge {

struct BridgeLianToroid {
  static constexpr std::string_view name = "lian_toroid";
  static constexpr std::string_view source = "Lian, Thornton and Adams (1993)";
  static constexpr BridgeRange range{0.0, 0.1, 0.7};

  static double force(const LiquidBridge& b, double gap) {
    const double beta = toroid_filling_angle(b, gap);
    const Toroid shape = toroid(b.radius, gap, b.contact_angle, beta);
    return pi * b.surface_tension * shape.neck * (1.0 + shape.neck * shape.curvature);
  }

  static double rupture_distance(const LiquidBridge& b) { return lian_rupture_distance(b); }
  static double scaled_volume(const LiquidBridge& b) { return reduced_volume(b); }
};

}  // namespace gasgrain::bridge
