// What the depth of a two-dimensional grid changes: void fraction, and the drag with it.
//
//   F = K U min(1, |L / L_s - 1|),   L_s = 2 / 3^(3/4) d,   number: L / L_s
//
// A plane of touching spheres in a grid of depth L_s has the void fraction of a bed in three
// dimensions; in one of depth L its solids are L_s / L of that. Nothing to correct on other grids
// (depth 0). Source: Hoomans et al. (2001), eqs 33 and 35. Inputs: drag, d, depth.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeDepthCorrection {
  static constexpr std::string_view name = "plane_of_spheres";
  static constexpr std::string_view number_name = "depth / (2 3^(-3/4) d)";
  static constexpr std::string_view threshold =
      "off 1 by 0.05, on a grid one cell deep (Hoomans et al. 2001, eq 35); not in the thesis";

  static double number(const Scales& at) {
    return ratio(at.depth, 2.0 * std::pow(3.0, -0.75) * at.diameter);
  }
  static double force(const Scales& at) {
    return at.depth > 0.0 ? at.drag * std::min(1.0, std::abs(number(at) - 1.0)) : 0.0;
  }
};

}  // namespace gasgrain
