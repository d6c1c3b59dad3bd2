// What a mixture of sizes changes in the drag.
//
//   F = K U max(d_max / d_s - 1, 1 - d_min / d_s),   number: d_max / d_min
//
// drag/polydisperse.h makes K of a grain y^2 K(d_s), y = d / d_s; with Stokes' K(d_s) = K(d) / y
// that is y K(d). At high Re, where K goes as d^2, nothing changes: an upper bound. Source: van der
// Hoef, Beetstra and Kuipers (2005). Inputs: d_max (= d), d_min, d_s, drag.
#pragma once

#include <algorithm>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizePolydisperse {
  static constexpr std::string_view name = "polydisperse";
  static constexpr std::string_view number_name = "d_max / d_min";
  static constexpr std::string_view threshold =
      "d / d_s off 1 by 0.05 (van der Hoef et al. 2005); not in the thesis";

  static double number(const Scales& at) { return ratio(at.diameter, at.smallest_diameter); }
  static double force(const Scales& at) {
    if (at.sauter_diameter <= 0.0) return 0.0;
    const double large = at.diameter / at.sauter_diameter - 1.0;
    const double small = 1.0 - at.smallest_diameter / at.sauter_diameter;
    return at.drag * std::max(large, small);
  }
};

}  // namespace gasgrain
