// What is at stake between the schemes that share the momentum of drag.
//
//   F = K v',   number: v' / U
//
// Schemes 1 and 2 take the mean velocity of the grains around where scheme 3 takes a grain's own:
// they differ by K (v - v_mean). Source: Feng and Yu (2004). Inputs: drag, U, v' (speed_scatter).
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeMomentumSharing {
  static constexpr std::string_view name = "momentum_sharing";
  static constexpr std::string_view number_name = "v' / U";
  static constexpr std::string_view threshold =
      "0.05: then only scheme_3 keeps momentum and damps v' (Feng, Yu 2004)";

  static double number(const Scales& at) { return ratio(at.speed_scatter, at.slip); }
  static double force(const Scales& at) {
    return at.slip > 0.0 ? at.drag * at.speed_scatter / at.slip : 0.0;
  }
};

}  // namespace gasgrain
