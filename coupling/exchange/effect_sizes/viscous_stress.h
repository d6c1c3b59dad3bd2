// Size of the force of the gas's viscous stress.
//
//   F = V_p |div tau|;   number: |div tau| d^2 / (18 mu U), its share of Stokes' drag
//
// With div tau = mu u / l^2 the number is (d / l)^2 / 18: small wherever the gas varies over more
// than a grain. Source: Maxey and Riley (1983). Inputs: d, mu, U, div tau. Exact.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/viscous_stress.h"

namespace gasgrain {

template <>
struct SizeOf<ForceViscousStress> {
  static constexpr std::string_view name = ForceViscousStress::name;
  static constexpr std::string_view number_name = "|div tau| d^2 / (18 mu U)";
  static constexpr std::string_view threshold =
      "0.05, (d/l)^2/18 (Maxey, Riley 1983); the thesis leaves it out";

  static double number(const Scales& at) {
    return ratio(at.viscous_force * at.diameter * at.diameter, 18.0 * at.viscosity * at.slip);
  }
  static double force(const Scales& at) { return at.volume() * at.viscous_force; }
};

}  // namespace gasgrain
