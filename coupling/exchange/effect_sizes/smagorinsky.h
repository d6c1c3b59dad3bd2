// Size of the subgrid stress of large eddies, on the gas of one grain.
//
//   F = mu_t u / l^2 V_p / phi,   mu_t = rho (C_s h)^2 u / l,   number: mu_t / mu
//
// u varies by itself over l (not less than a cell h). Source: Smagorinsky (1963). Inputs: rho, mu,
// u, l, h, C_s, eps.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeSmagorinsky {
  static constexpr std::string_view name = "turbulence smagorinsky";
  static constexpr std::string_view number_name = "mu_t / mu";
  static constexpr std::string_view threshold =
      "stress / drag of 0.05 (Smagorinsky 1963); thesis table 10.2: deactivated";

  static double length(const Scales& at) { return std::max(at.gas_length, at.cell); }
  static double eddy_viscosity(const Scales& at) {
    const double filter = at.smagorinsky_constant * at.cell;
    return at.gas_density * filter * filter * ratio(at.gas_speed, length(at));
  }
  static double number(const Scales& at) { return ratio(eddy_viscosity(at), at.viscosity); }
  static double force(const Scales& at) {
    if (at.gas_speed == 0.0) return 0.0;
    return at.per_grain(eddy_viscosity(at) * at.gas_speed / (length(at) * length(at)));
  }
};

}  // namespace gasgrain
