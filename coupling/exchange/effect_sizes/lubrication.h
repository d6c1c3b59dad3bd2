// Size of the squeezed gas film between two grains that approach.
//
//   F = 3/8 pi mu d v' (d / s), s = d / 100,   number: St = rho_p v' d / (9 mu)
//
// s is where roughness or the next step ends the approach. Above St = 1000 a rebound is a dry one,
// below 10 there is none: P. Gondret, M. Lance, L. Petit, Phys. Fluids 14 (2002) 643. Source of F:
// Reynolds' film between two equal spheres. Inputs: d, mu, v' (speed_scatter), rho_p.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeLubrication {
  static constexpr std::string_view name = "lubrication";
  static constexpr std::string_view number_name = "St = rho_p v' d / (9 mu)";
  static constexpr std::string_view threshold =
      "0.05; St below 1000 (Gondret et al. 2002); thesis: not mentioned";

  static double number(const Scales& at) {
    return ratio(at.solid_density * at.speed_scatter * at.diameter, 9.0 * at.viscosity);
  }
  static double force(const Scales& at) {
    constexpr double over_gap = 100.0;
    return 0.375 * pi * at.viscosity * at.diameter * at.speed_scatter * over_gap;
  }
};

}  // namespace gasgrain
