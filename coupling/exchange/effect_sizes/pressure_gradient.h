// Size of the force of the gas pressure.
//
//   F = V_p |grad p|;   number: |grad p| / (rho_p g)
//
// In a fluidised bed grad p carries the solids, (1 - eps) (rho_p - rho) g: the number is then 1 -
// eps, some 0.6 of the weight whatever the gas. In a dilute gas it is rho / rho_p. Source: the
// force itself; balance of a fluidised bed: Ergun (1952). Inputs: d, grad p. Exact.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/pressure_gradient.h"

namespace gasgrain {

template <>
struct SizeOf<ForcePressureGradient> {
  static constexpr std::string_view name = ForcePressureGradient::name;
  static constexpr std::string_view number_name = "|grad p| / (rho_p g)";
  static constexpr std::string_view threshold =
      "0.05; 1 - eps in a fluidised bed (Ergun 1952); thesis 5.3: not to be disregarded";

  static double number(const Scales& at) {
    return ratio(at.pressure_gradient, at.solid_density * at.gravity);
  }
  static double force(const Scales& at) { return at.volume() * at.pressure_gradient; }
};

}  // namespace gasgrain
