// The true force of a bridge without gravity: the meridian of constant mean curvature, integrated.
//
// In units of the sphere's radius and the surface tension, s along the meridian from the contact
// circle of the sphere, phi the meridian's angle to the axis:
//   dx/ds = cos phi, dy/ds = sin phi, dphi/ds = cos phi / y - P, dV/ds = pi y^2 cos phi
// from y = sin beta, phi = beta + theta - pi/2 to the neck (phi = 0, two equal spheres) or to the
// wall (phi = pi/2 - theta). Half-filling angle beta and pressure P are found for a volume and a
// gap by Newton's method, from contact outwards in small steps of the gap.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fix_cfd_coupling/dem_physics/bridge/toroid.h"

namespace gasgrain::bridge::test {

struct YoungLaplace {
  bool on_wall;
  double theta;
  double volume;  // V / r^3, r the grain's own radius
  double beta = 0.0;
  double pressure = 0.0;

  using State = std::array<double, 4>;  // x, y, phi, V
  State slope(const State& q) const {
    const double c = std::cos(q[2]);
    return {c, std::sin(q[2]), c / q[1] - pressure, pi * q[1] * q[1] * c};
  }
  // One classical Runge-Kutta step in s, or in phi.
  State step(const State& q, double length, bool in_angle) const {
    const auto f = [&](const State& at) {
      State d = slope(at);
      if (in_angle) {
        const double turn = d[2];
        for (double& value : d) value /= turn;
      }
      return d;
    };
    const auto moved = [](const State& from, const State& by, double l) {
      State to = from;
      for (int n = 0; n < 4; ++n) to[n] += l * by[n];
      return to;
    };
    const State a = f(q), b = f(moved(q, a, 0.5 * length)), c = f(moved(q, b, 0.5 * length)),
                d = f(moved(q, c, length));
    State to = q;
    for (int n = 0; n < 4; ++n) to[n] += length / 6.0 * (a[n] + 2.0 * b[n] + 2.0 * c[n] + d[n]);
    return to;
  }
  // Gap and volume of the meridian with the present beta and pressure; NaN when it does not arrive.
  std::array<double, 2> arrive() const {
    const double end = on_wall ? 0.5 * pi - theta : 0.0;
    State q{0.0, std::sin(beta), beta + theta - 0.5 * pi, 0.0};
    const double cap_height = 1.0 - std::cos(beta);
    for (int n = 0; n < 4000; ++n) {
      const double turn = slope(q)[2];
      const double length = 0.02 * std::min(q[1], 1.0 / (std::abs(turn) + 1e-300));
      const State next = step(q, length, false);
      if (next[2] >= end) {
        q = step(q, end - q[2], true);
        const double sides = on_wall ? 1.0 : 2.0;
        const double solid = pi * cap_height * cap_height * (1.0 - cap_height / 3.0);
        return {sides * (q[0] - cap_height), sides * (q[3] - solid)};
      }
      if (!(next[1] > 0.0)) break;
      q = next;
    }
    return {std::nan(""), std::nan("")};
  }
  // F / (gamma r), the same at every section.
  double force() const {
    const double y = std::sin(beta);
    return 2.0 * pi * y * std::sin(beta + theta) - pi * y * y * pressure;
  }
  bool solve(double gap) {
    const double scale = std::cbrt(volume);
    const auto residual = [&] {
      const auto [s, v] = arrive();
      return std::array<double, 2>{(s - gap) / scale, v / volume - 1.0};
    };
    auto r = residual();
    for (int n = 0; n < 60; ++n) {
      const double size = std::abs(r[0]) + std::abs(r[1]);
      if (size < 1e-9) return true;
      const double beta0 = beta, p0 = pressure, db = 1e-6 * beta0,
                   dp = 1e-6 * (std::abs(p0) + 0.1 / beta0);
      beta = beta0 + db;
      const auto rb = residual();
      beta = beta0;
      pressure = p0 + dp;
      const auto rp = residual();
      pressure = p0;
      const double a = (rb[0] - r[0]) / db, b = (rp[0] - r[0]) / dp, c = (rb[1] - r[1]) / db,
                   d = (rp[1] - r[1]) / dp, det = a * d - b * c;
      const double step_beta = -(d * r[0] - b * r[1]) / det;
      const double step_p = -(-c * r[0] + a * r[1]) / det;
      double share = std::min(1.0, 0.2 * beta0 / std::abs(step_beta));
      bool better = false;
      for (int m = 0; m < 20 && !better; ++m, share *= 0.5) {
        beta = beta0 + share * step_beta;
        pressure = p0 + share * step_p;
        const auto tried = residual();
        better = std::abs(tried[0]) + std::abs(tried[1]) < size;
        if (better) r = tried;
      }
      if (!better) return false;
    }
    return false;
  }
  // F / (gamma r) at a gap / r, followed from contact; NaN beyond the last stable bridge.
  double force_at(double gap) {
    // A wall bridge begins from that of the pair it mirrors: half the gap, half the liquid.
    const double r = on_wall ? 2.0 : 1.0;
    const LiquidBridge first{r, theta, 1.0, volume, on_wall, std::cos(theta)};
    const double beta_d = toroid_filling_angle(first, 0.0);
    const Toroid shape = toroid(r, 0.0, theta, beta_d);
    beta = std::asin(std::min(0.99, r * std::sin(beta_d)));
    pressure = 1.0 / shape.neck - shape.curvature;
    const double widest = 0.02 * std::cbrt(volume);
    const int steps = std::max(1, static_cast<int>(std::ceil(gap / widest)));
    for (int n = 0; n <= steps; ++n)
      if (!solve(gap * n / steps)) return std::nan("");
    return force();
  }
};

}  // namespace gasgrain::bridge::test
