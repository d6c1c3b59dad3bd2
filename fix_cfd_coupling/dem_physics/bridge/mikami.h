// Capillary force as Mikami, Kamiya and Horio fitted it to the Young-Laplace equation.
//
//   F / (pi r gamma) = exp(A s / r + B) + C,   v = V / r^3,   L = ln v
//   grain - grain: A = -1.1 v^-0.53
//                  B = (-0.034 L - 0.96) theta^2 - 0.019 L + 0.48
//                  C = 0.0042 L + 0.078
//                  rupture at s / r = (0.62 theta + 0.99) v^0.34
//   grain - wall:  A = -1.9 v^-0.51
//                  B = (-0.016 L - 0.76) theta^2 - 0.012 L + 1.2
//                  C = 0.013 L + 0.18
//                  rupture at s / r = (0.22 theta + 0.95) v^0.32
// r: Derjaguin's radius of two grains, the grain's own on a wall.
//
// Source: Mikami, Kamiya and Horio, Chem. Eng. Sci. 53 (1998) 1927; Alobaid (2013), eqs 5.68-5.74.
// Inputs, output: bridges.h.
// Range: v 1e-4 to 0.1, theta to 40 degrees. Up to 0.3 of Lian's rupture distance grain - grain is
//   within 14 % of the Young-Laplace equation, grain - wall within 13 % from v = 1e-3 and 29 % from
//   1e-4. An exponential and a constant cannot follow the tail: 0.7 to 1.3 of it, 2.0 on walls.
// Deviations from eqs 5.70 and 5.71 as the thesis prints them, each decided by the Young-Laplace
//   equation (tests/bridges/young_laplace.h):
//   - -0.034 L theta^2 for -0.34: the printed one triples the force with theta at v = 1e-3, 40
//     degrees (2.65 of the true one at contact; 0.97 with -0.034).
//   - wall: -0.012 L for -0.12: the printed one is 1.6 of the true force at contact at v = 1e-2 and
//     2.6 at 1e-4, this 0.98 and 0.96.
//   - wall: C's 0.013 for 0.0013: at 0.9 of the rupture distance, v = 1e-4, the printed one is 3.6
//     of the true force, this 1.3.
//   - below v = 1e-5 L in B and C stays at ln 1e-5, where the fit meets 2 pi r gamma cos theta:
//     further on B would grow without bound and C become a repulsion.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

struct BridgeMikami {
  static constexpr std::string_view name = "mikami";
  static constexpr std::string_view source = "Mikami, Kamiya and Horio (1998)";
  static constexpr BridgeRange range{1e-4, 0.1, 0.7};
  static constexpr double logarithm_down_to = 1e-5;  // v

  static double force(const LiquidBridge& b, double gap) {
    const double r = scale_radius(b);
    const double v = scaled_volume(b);
    const double log_v = std::log(std::max(v, logarithm_down_to));
    const double theta2 = b.contact_angle * b.contact_angle;
    const double a = b.on_wall ? -1.9 * std::pow(v, -0.51) : -1.1 * std::pow(v, -0.53);
    const double of_angle = b.on_wall ? -0.016 * log_v - 0.76 : -0.034 * log_v - 0.96;
    const double at_0 = b.on_wall ? -0.012 * log_v + 1.2 : -0.019 * log_v + 0.48;
    const double c = b.on_wall ? 0.013 * log_v + 0.18 : 0.0042 * log_v + 0.078;
    return pi * r * b.surface_tension * (std::exp(a * gap / r + of_angle * theta2 + at_0) + c);
  }

  static double rupture_distance(const LiquidBridge& b) {
    const double r = scale_radius(b);
    const double v = scaled_volume(b);
    return b.on_wall ? r * (0.22 * b.contact_angle + 0.95) * std::pow(v, 0.32)
                     : r * (0.62 * b.contact_angle + 0.99) * std::pow(v, 0.34);
  }

  static double scale_radius(const LiquidBridge& b) {
    return b.on_wall ? 0.5 * b.radius : b.radius;
  }
  static double scaled_volume(const LiquidBridge& b) {
    const double r = scale_radius(b);
    return b.volume / (r * r * r);
  }
};

}  // namespace gasgrain::bridge
