// What a grain's own disturbance of the gas changes in its drag.
//
//   F = K U share / (1 - share),   number: share = alone K R
//
// R as in self_disturbance.h for one length s, the standard deviation of the grain's weights;
// `alone` falls to 0 in a bed. Source: there. Inputs: drag, U, rho, mu, s (bell), eps.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/self_disturbance.h"

namespace gasgrain {

struct SizeSelfDisturbance {
  static constexpr std::string_view name = "self_disturbance";
  static constexpr std::string_view number_name =
      "K R, R = 1 / (6 pi^(3/2) mu s (1 + 0.752 rho U s / mu))";
  static constexpr std::string_view threshold = "0.05 (self_disturbance.h); not in the thesis";

  static double number(const Scales& at) {
    if (at.bell <= 0.0 || at.slip <= 0.0 || at.viscosity <= 0.0) return 0.0;
    const double stokes = 6.0 * std::pow(pi, 1.5) * at.viscosity * at.bell;
    const double wake =
        4.0 / (3.0 * std::sqrt(pi)) * at.gas_density * at.slip * at.bell / at.viscosity;
    return alone(at.solids()) * at.drag / (at.slip * stokes * (1.0 + wake));
  }
  static double force(const Scales& at) {
    const double share = std::min(number(at), greatest_share);
    return at.drag * share / (1.0 - share);
  }
};

}  // namespace gasgrain
