// Bridges that the tests go through.
#pragma once

#include <array>

#include "coupling/base/choice_list.h"
#include "fix_cfd_coupling/dem_physics/bridge/bridges.h"

namespace gasgrain::bridge::test {

inline constexpr double gamma_water = 0.0728;  // [N/m]
inline constexpr double degree = pi / 180.0;
inline constexpr std::array<double, 3> reduced_volumes{1e-4, 1e-3, 5e-2};  // V / r^3
inline constexpr std::array<double, 4> gap_shares{0.0, 0.1, 0.4, 0.9};  // of the rupture distance

// Two grains of 1 mm diameter, or one on a wall; V / r^3 as given.
inline LiquidBridge equal_grains(double v, double theta) {
  const double r = 0.5e-3;
  return bridge_of_grains(r, r, theta, theta, gamma_water, v * r * r * r);
}
inline LiquidBridge grain_on_wall(double v, double theta) {
  const double r = 0.5e-3;
  return bridge_on_wall(r, theta, theta, gamma_water, v * r * r * r);
}
// Grains of size ratio 15 and unequal angles; V / R^3 as given.
inline LiquidBridge unequal_grains(double v, double theta) {
  const double large = 1.5e-3, small = 0.1e-3, r = 2.0 * large * small / (large + small);
  return bridge_of_grains(large, small, 0.5 * theta, 1.5 * theta, gamma_water, v * r * r * r);
}

template <class F>
void for_each_bridge(const F& f) {
  for (const double v : reduced_volumes)
    for (const double theta : {0.0, 20.0 * degree, 40.0 * degree})
      for (const LiquidBridge& b :
           {equal_grains(v, theta), grain_on_wall(v, theta), unequal_grains(v, theta)})
        f(b);
}

template <class F>
void for_each_law(const F& f) {
  for_each_choice<BridgeLaw>(f);
}

}  // namespace gasgrain::bridge::test
