// The shape of a bridge whose meridian is an arc of a circle, between two equal spheres.
//
//   h = s/2 + R (1 - cos beta),  alpha = beta + theta
//   kappa = 1 / R1 = cos alpha / h                            meridional curvature [1/m]
//   R2 = R sin beta - h cos alpha / (1 + sin alpha)           radius of the neck [m]
//   y(x) = R2 + R1 - sqrt(R1^2 - x^2),  -h <= x <= h          meridian, x = 0 at the neck
//   V = 2 pi integral_0^h y^2 dx - 2 pi/3 R^3 (1 - cos beta)^2 (2 + cos beta)
//
// Source: Fisher, J. Agric. Sci. 16 (1926) 492; Lian, Thornton and Adams, J. Colloid Interface Sci.
//   161 (1993) 138.
// Inputs: R sphere, s gap >= 0 [m], theta contact angle, beta half-filling angle [rad].
// Range: alpha from 0 to pi. Where alpha passes pi/2 the meridian passes a cylinder (R1 infinite);
//   with t = cos alpha the integral is written so that this is an ordinary point. At given V and s
//   there may be no toroid (R2 <= 0: the gap is too wide) or none below beta = pi/2 (too much
//   liquid).
#pragma once

#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/bridge/liquid_bridge.h"

namespace gasgrain::bridge {

struct Toroid {
  double half_length;  // h [m]
  double curvature;    // 1 / R1 [1/m], positive when the bridge is waisted
  double neck;         // R2 [m]
};

inline Toroid toroid(double radius, double gap, double theta, double beta) {
  const double alpha = beta + theta;
  const double half_sine = std::sin(0.5 * beta);
  const double h = 0.5 * gap + 2.0 * radius * half_sine * half_sine;
  const double t = std::cos(alpha);
  return {h, t / h, radius * std::sin(beta) - h * t / (1.0 + std::sin(alpha))};
}

// integral_0^1 g du and g^2 du of the bulge g = (1 - sqrt(1 - t^2 u^2)) / t of the meridian over
// its neck, in units of h.
struct Bulge {
  double first;
  double second;
};
inline Bulge toroid_bulge(double alpha) {
  const double t = std::cos(alpha);
  const double t2 = t * t;
  constexpr double series_below = 0.05;  // the closed form would lose 6 digits, the series 1e-12
  if (std::abs(t) < series_below)
    return {t * (1.0 / 6.0 + t2 * (1.0 / 40.0 + t2 * (1.0 / 112.0 + t2 * 5.0 / 1152.0))),
            t2 * (1.0 / 20.0 + t2 * (1.0 / 56.0 + t2 * (5.0 / 576.0 + t2 * 7.0 / 1408.0)))};
  const double root = std::sin(alpha) + std::asin(t) / t;  // 2 integral sqrt(1 - t^2 u^2)
  return {(1.0 - 0.5 * root) / t, (2.0 - t2 / 3.0 - root) / t2};
}

// Liquid [m3] of the toroid with this half-filling angle.
inline double toroid_volume(double radius, double gap, double theta, double beta) {
  const Toroid shape = toroid(radius, gap, theta, beta);
  const Bulge bulge = toroid_bulge(beta + theta);
  const double h = shape.half_length;
  const double half_sine = std::sin(0.5 * beta);
  const double cap_height = 2.0 * radius * half_sine * half_sine;
  const double solid = cap_height * cap_height * (radius - cap_height / 3.0);
  return 2.0 * pi *
         (h * (shape.neck * shape.neck + h * (2.0 * shape.neck * bulge.first + h * bulge.second)) -
          solid);
}

// Half-filling angle of a bridge. Where no toroid has this volume: the least angle that has a neck
// when the gap is too wide, pi/2 when there is too much liquid. The volume grows with the angle,
// nearly as a power of it: secants of the logarithms within a bracket, which is halved when they
// leave it.
inline double toroid_filling_angle(const LiquidBridge& b, double gap) {
  constexpr double resolved = 1e-13;  // of the angle, relative
  double low = std::log(1e-8);
  double high = std::log(0.5 * pi);
  // A flat cylinder between parabolic caps has beta^2 R = 2 d (rabinovich_energy.h).
  const double q = 2.0 * b.volume / (pi * b.radius);
  double at = 0.5 * std::log(q / ((gap + std::sqrt(gap * gap + q)) * b.radius));
  double last_at = 0.0;
  double last_excess = 0.0;
  bool has_last = false;
  at = at > low && at < high ? at : 0.5 * (low + high);
  for (int n = 0; n < 100 && high - low > resolved; ++n) {
    const double beta = std::exp(at);
    double next = 0.0;
    if (toroid(b.radius, gap, b.contact_angle, beta).neck > 0.0) {
      const double excess =
          std::log(toroid_volume(b.radius, gap, b.contact_angle, beta) / b.volume);
      (excess > 0.0 ? high : low) = at;
      const double slope = has_last ? (excess - last_excess) / (at - last_at) : 3.0;
      next = at - excess / slope;
      last_at = at;
      last_excess = excess;
      has_last = true;
    } else {
      low = at;
      next = low;  // beyond the bracket
    }
    if (std::abs(next - at) < resolved && has_last && last_at == at) return std::exp(next);
    at = next > low && next < high ? next : 0.5 * (low + high);
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace gasgrain::bridge
