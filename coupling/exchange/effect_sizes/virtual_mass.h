// Size of the virtual mass.
//
//   F = rho V_p / 2 (|Du/Dt| + |dv/dt|);   number: rho / (2 rho_p)
//
// The number is its share of what accelerates the grain; beside it the gas's own acceleration
// counts, which in a jet is u^2 / x. Source: Auton, Hunt and Prud'homme (1988). Inputs: d, both
// densities, both accelerations. An upper bound: the accelerations are taken as opposed.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/virtual_mass.h"

namespace gasgrain {

template <>
struct SizeOf<ForceVirtualMass> {
  static constexpr std::string_view name = ForceVirtualMass::name;
  static constexpr std::string_view number_name = "rho / (2 rho_p)";
  static constexpr std::string_view threshold =
      "0.05: liquids, bubbles (Auton et al. 1988); thesis 5.3: can be omitted in gas";

  static double number(const Scales& at) { return ratio(0.5 * at.gas_density, at.solid_density); }
  static double force(const Scales& at) {
    return 0.5 * at.gas_density * at.volume() * at.relative_acceleration();
  }
};

}  // namespace gasgrain
