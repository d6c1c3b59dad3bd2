// Size of Magnus' lift by spin.
//
//   F = pi/8 d^2 rho 0.4 min(1, G) U^2,   number: G = d Omega / (2 U),   Omega = w / 2 + omega_p
//
// Source: Tsuji, Morikawa and Mizuno (1985). Inputs: d, rho, U, w, spin. Spin and vorticity are
// taken as opposed and across the slip: the greatest.
#pragma once

#include <algorithm>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/magnus.h"

namespace gasgrain {

template <>
struct SizeOf<ForceMagnus> {
  static constexpr std::string_view name = ForceMagnus::name;
  static constexpr std::string_view number_name = "d Omega / (2 U)";
  static constexpr std::string_view threshold =
      "F / drag of 0.05 (Tsuji et al. 1985; data from Re = 550); thesis 5.3: should be considered";

  static double number(const Scales& at) { return ratio(0.5 * at.diameter * at.turn(), at.slip); }
  static double force(const Scales& at) {
    constexpr double lift = 0.4;
    if (at.turn() == 0.0) return 0.0;
    return 0.125 * pi * at.diameter * at.diameter * at.gas_density * lift *
           std::min(1.0, number(at)) * at.slip * at.slip;
  }
};

}  // namespace gasgrain
