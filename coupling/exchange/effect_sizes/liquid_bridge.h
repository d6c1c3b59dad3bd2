// Size of a bridge of water between two grains.
//
//   F = pi d gamma,   number: the granular Bond number Bo = F / (m g)
//
// of equal spheres that touch, wetted wholly, whatever the bridge's volume. gamma = 0.0728 N/m,
// water at 20 C. Source: R.A. Fisher, J. Agric. Sci. 16 (1926) 492. Inputs: d, weight. Dry grains
// have none.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeLiquidBridge {
  static constexpr std::string_view name = "liquid bridges";
  static constexpr std::string_view number_name = "Bo = pi d gamma / (m g)";
  static constexpr std::string_view threshold =
      "Bo of 0.05, wet grains only; thesis 5.3: a major influence when wet";

  static double number(const Scales& at) { return ratio(force(at), at.weight()); }
  static double force(const Scales& at) {
    constexpr double surface_tension = 0.0728;  // [N/m]
    return pi * at.diameter * surface_tension;
  }
};

}  // namespace gasgrain
