// What lies between the models A and B of the pressure gradient.
//
//   F = rho V_p |Du/Dt|,   number: rho |Du/Dt| / (rho_p g)
//
// In a uniform bed both give the same force (drag/basis.h). They differ where the gas accelerates:
// the pressure gradient that does it acts on grains in A and not in B. Source: own, from the two
// balances (Hoomans et al. 2001). Inputs: rho, d, Du/Dt.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeModelB {
  static constexpr std::string_view name = "model B";
  static constexpr std::string_view number_name = "rho |Du/Dt| / (rho_p g)";
  static constexpr std::string_view threshold =
      "0.05: there A and B differ, and A is the derived one; thesis: A";

  static double number(const Scales& at) {
    return ratio(at.gas_density * at.gas_acceleration, at.solid_density * at.gravity);
  }
  static double force(const Scales& at) {
    return at.gas_density * at.volume() * at.gas_acceleration;
  }
};

}  // namespace gasgrain
