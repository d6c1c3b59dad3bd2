// The neck of a parabolic meridian decides where a bridge parts.
//
//   y(x) = k x^2 on either side of the neck, where at rupture y = 0 and dy/dx = 0 (5.88, 5.89).
//   On grain n, of half-filling angle b_n, it ends at the contact circle, at the contact angle:
//     y = r_n sin b_n,   dy/dx = cot(b_n + theta_n)
//   so that x = 2 y tan(b_n + theta_n),   k = cot^2(b_n + theta_n) / (4 r_n sin b_n)
//   V_n = pi y^2 x / 5 - pi/3 r_n^3 (1 - cos b_n)^2 (2 + cos b_n)                 (5.79, 5.80)
//   k is the one of V_i(k) + V_j(k) = V (5.81).
//   Wall: y = cot^2(theta) / (4 k), no cap: V_n = pi cot^5(theta) / (160 k^3).
//
// Source: Shi and McCarthy, Powder Technol. 184 (2008) 64; Alobaid (2013), eqs 5.76-5.89.
// Assumes: no viscosity, no gravity. Grain or wall of 90 degrees keeps nothing, a wall of 0 keeps
//   all (the meridian ends where it is flat); two of a kind, of those, have half each.
// Range: V / r^3 below 0.1. Small volumes between partly wetted grains part as cot^5 theta, that is
//   steeply: 30 and 60 degrees share 243 : 1. Perfectly wetted ones share as r^(5/3).
// Deviations: eqs 5.82 and 5.83 of the thesis fix the contact circle at r_i r_j / (r_i + r_j) for
//   both, whatever the liquid. Then the neck is always in the middle, the contact angles do not
//   enter, and 5.81 does not hold. Here the contact angles set the slopes, and 5.81 the scale.
//   k, a scale over many decades, is found by bisection of its logarithm; the share is right to
//   1e-12, the sum exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fix_cfd_coupling/dem_physics/liquid/broken_bridge.h"

namespace gasgrain::liquid {

struct DivisionShiMcCarthy {
  static constexpr std::string_view name = "shi_mccarthy";
  static constexpr std::string_view source = "Shi and McCarthy (2008)";

  static Division divide(const BrokenBridge& b) {
    if (!(b.volume > 0.0)) return {0.0, b.volume};
    const bool takes_i = keeps_all(b.i) || keeps_none(b.j);
    const bool takes_j = keeps_all(b.j) || keeps_none(b.i);
    if (takes_i || takes_j) return divide_by_share(b.volume, takes_i == takes_j ? 0.5 : takes_i);
    // Of equal partners without the search for k, which takes as long as thousands of bridge
    // forces.
    if (b.i.radius == b.j.radius && b.i.contact_angle == b.j.contact_angle)
      return divide_by_share(b.volume, 0.5);
    const double at = log_curvature(b);
    const double v_i = held(b.i, at);
    const double v_j = held(b.j, at);
    return divide_by_share(b.volume, v_i / (v_i + v_j));
  }

  // Liquid [m3] on one side of a meridian y = exp(log_k) x^2.
  static double held(const Partner& p, double log_k) {
    if (std::isinf(p.radius)) {
      const double cot = 1.0 / std::tan(p.contact_angle);
      return pi / 160.0 * std::exp(5.0 * std::log(cot) - 3.0 * log_k);
    }
    const double beta = filling_angle(p, log_k);
    const double y = std::sin(beta);
    const double half_sine = std::sin(0.5 * beta);
    const double cap = 2.0 * half_sine * half_sine;  // 1 - cos beta
    return pi * p.radius * p.radius * p.radius *
           (0.4 * y * y * y * std::tan(beta + p.contact_angle) - cap * cap * (1.0 - cap / 3.0));
  }

 private:
  static constexpr double pi = 3.14159265358979323846;

  static bool keeps_none(const Partner& p) { return p.contact_angle >= 0.5 * pi; }
  static bool keeps_all(const Partner& p) { return std::isinf(p.radius) && p.contact_angle <= 0.0; }

  // Of cot^2(beta + theta) = 4 k r sin beta: its left side falls, its right side grows with beta.
  static double filling_angle(const Partner& p, double log_k) {
    const double scale = 4.0 * p.radius * std::exp(log_k);
    double low = 0.0;
    double high = 0.5 * pi - p.contact_angle;
    for (int n = 0; n < 90 && high - low > 1e-15 * high; ++n) {
      const double middle = 0.5 * (low + high);
      const double cot = 1.0 / std::tan(middle + p.contact_angle);
      (cot * cot > scale * std::sin(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  // The more curved the meridian, the less liquid.
  static double log_curvature(const BrokenBridge& b) {
    const double size = std::log(std::min(b.i.radius, b.j.radius));
    double low = -size - 40.0;
    double high = -size + 60.0;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (held(b.i, middle) + held(b.j, middle) > b.volume ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
};

}  // namespace gasgrain::liquid
