// Size of the lift by shear.
//
//   F = 1.615 d^2 (rho mu w)^(1/2) U (e^(-Re/10) + 0.0524 (beta Re)^(1/2)),  beta = d w / (2 U)
//   number: beta
//
// Source: Saffman (1965, 1968); f as the sum of both ends of Mei's (1992), within 1.7 of it from
// Re = 0.1 to 100 and beta = 0.005 to 0.4, where his data are, and equal to it far above Re = 40.
// Inputs: d, rho, mu, U, w. Slip and vorticity are taken as perpendicular: the greatest.
#pragma once

#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/saffman_mei.h"

namespace gasgrain {

template <>
struct SizeOf<ForceSaffmanMei> {
  static constexpr std::string_view name = ForceSaffmanMei::name;
  static constexpr std::string_view number_name = "d w / (2 U)";
  static constexpr std::string_view threshold =
      "F / drag of 0.05 (Mei 1992; data to Re = 100); thesis 5.3: not to be disregarded";

  static double number(const Scales& at) {
    return ratio(0.5 * at.diameter * at.vorticity, at.slip);
  }
  static double force(const Scales& at) {
    if (at.slip == 0.0 || at.vorticity == 0.0) return 0.0;
    const double re = at.reynolds();
    const double f = std::exp(-0.1 * re) + 0.0524 * std::sqrt(number(at) * re);
    return 1.615 * at.diameter * at.diameter *
           std::sqrt(at.gas_density * at.viscosity * at.vorticity) * at.slip * f;
  }
};

}  // namespace gasgrain
