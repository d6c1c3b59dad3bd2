// What compressibility changes: density, and the drag with it.
//
//   F = K U max(dp, rho u^2 / 2) / p,   number: that ratio, the relative change of the density
//
// dp is the bed's pressure drop, rho u^2 / 2 the pressure of stagnation. Source: the ideal gas,
// isothermal. Inputs: drag, dp, rho, u, absolute pressure.
#pragma once

#include <algorithm>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeIdealGas {
  static constexpr std::string_view name = "law ideal_gas";
  static constexpr std::string_view number_name = "max(dp, rho u^2 / 2) / p";
  static constexpr std::string_view threshold =
      "0.05 (Mach number 0.27; or a bed of 50 hPa at 1 atm); thesis: incompressible cold beds";

  static double number(const Scales& at) {
    const double stagnation = 0.5 * at.gas_density * at.gas_speed * at.gas_speed;
    return ratio(std::max(at.pressure_drop, stagnation), at.gas_pressure);
  }
  static double force(const Scales& at) { return at.drag * number(at); }
};

}  // namespace gasgrain
