// Size of the turbulent stress of the mean flow, on the gas of one grain.
//
//   F = mu_t u / l^2 V_p / phi,   mu_t = 0.028 rho u l,   number: rho u l / mu
//
// l is the half width of the flow. 0.028 is that of a round jet: S.B. Pope, Turbulent Flows
// (2000), 5.1. Below a number of 2300 the gas is laminar and the size 0. Inputs: rho, mu, u, l,
// eps.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeKEpsilon {
  static constexpr std::string_view name = "turbulence k_epsilon";
  static constexpr std::string_view number_name = "rho u l / mu";
  static constexpr std::string_view threshold =
      "rho u l / mu above 2300 and stress / drag of 0.05 (Pope 2000); thesis table 10.2: "
      "deactivated";

  static constexpr double laminar = 2300.0;

  static double number(const Scales& at) {
    return ratio(at.gas_density * at.gas_speed * at.gas_length, at.viscosity);
  }
  static double force(const Scales& at) {
    if (at.gas_length <= 0.0 || number(at) < laminar) return 0.0;
    constexpr double of_jet = 0.028;
    return at.per_grain(of_jet * at.gas_density * at.gas_speed * at.gas_speed / at.gas_length);
  }
};

}  // namespace gasgrain
