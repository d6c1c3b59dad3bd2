// Size of Basset's history force.
//
//   F = 3/2 d^2 (pi rho mu)^(1/2) a 2 t^(1/2),   a = |Du/Dt| + |dv/dt|,   t = U / a
//   number: (18 rho / (pi rho_p))^(1/2), its share of Stokes' drag on a grain that follows it
//
// a is held for the time t in which the slip changes by itself. Source: Basset (1888), with the
// slip a straight line in time; the number: a = U / t and t = rho_p d^2 / (18 mu). Inputs: d, rho,
// mu, U, accelerations. An upper bound above Re = 1, as the force itself (forces/basset.h).
#pragma once

#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/basset.h"

namespace gasgrain {

template <>
struct SizeOf<ForceBasset> {
  static constexpr std::string_view name = ForceBasset::name;
  static constexpr std::string_view number_name = "(18 rho / (pi rho_p))^(1/2)";
  static constexpr std::string_view threshold =
      "0.05 (Basset 1888), to Re = 1 and not advised beyond; thesis 5.3: can be omitted in gas";

  static double number(const Scales& at) {
    return std::sqrt(ratio(18.0 * at.gas_density, pi * at.solid_density));
  }
  // Beyond it the force as programmed is too great, by how much nobody knows.
  static bool in_range(const Scales& at) { return at.reynolds() <= 1.0; }
  // In which the slip changes by as much as it is [s].
  static double duration(const Scales& at) { return ratio(at.slip, at.relative_acceleration()); }
  static double force(const Scales& at) {
    const double a = at.relative_acceleration();
    if (a == 0.0) return 0.0;
    return 3.0 * at.diameter * at.diameter * std::sqrt(pi * at.gas_density * at.viscosity) * a *
           std::sqrt(duration(at));
  }
};

}  // namespace gasgrain
