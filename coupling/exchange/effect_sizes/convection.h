// What the upwind scheme adds to the gas's momentum: a stress that is none, on the gas of one
// grain.
//
//   F = mu_h u / l^2 V_p / phi,   mu_h = rho u h / 2,   number: rho u h / mu
//
// Source: the leading error of first-order upwind differences. Inputs: rho, mu, u, l (not less than
// h), h, eps.
#pragma once

#include <algorithm>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeConvection {
  static constexpr std::string_view name = "convection";
  static constexpr std::string_view number_name = "rho u h / mu";
  static constexpr std::string_view threshold =
      "upwind's stress / drag of 0.05: then a scheme of second order; thesis table 10.2: central";

  static double number(const Scales& at) {
    return ratio(at.gas_density * at.gas_speed * at.cell, at.viscosity);
  }
  static double force(const Scales& at) {
    if (at.gas_speed == 0.0 || at.cell == 0.0) return 0.0;
    const double l = std::max(at.gas_length, at.cell);
    const double numerical_viscosity = 0.5 * at.gas_density * at.gas_speed * at.cell;
    return at.per_grain(numerical_viscosity * at.gas_speed / (l * l));
  }
};

}  // namespace gasgrain
