// Size of the gas's torque, as a force at the grain's surface.
//
//   F = T / (d/2),   T = pi mu d^3 Omega (1 + 0.13 R^(1/2)),   number: R = rho d^2 Omega / (4 mu)
//
// Source: Stokes' torque, and the laminar branch of Dennis, Singh and Ingham (1980) for great R:
// within 1.35 of forces/rotation_torque.h up to R = 1e4. Inputs: d, rho, mu, w, spin.
#pragma once

#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/rotation_torque.h"

namespace gasgrain {

template <>
struct SizeOf<ForceRotationTorque> {
  static constexpr std::string_view name = ForceRotationTorque::name;
  static constexpr std::string_view number_name = "rho d^2 Omega / (4 mu)";
  static constexpr std::string_view threshold =
      "T / (m g d/2) of 0.05 (Dennis et al. 1980); thesis 5.3: included";

  static double number(const Scales& at) {
    return ratio(0.25 * at.gas_density * at.diameter * at.diameter * at.turn(), at.viscosity);
  }
  static double torque(const Scales& at) {
    if (at.turn() == 0.0 || at.viscosity == 0.0) return 0.0;
    return pi * at.viscosity * std::pow(at.diameter, 3) * at.turn() *
           (1.0 + 0.13 * std::sqrt(number(at)));
  }
  static double force(const Scales& at) { return ratio(torque(at), at.radius()); }
};

}  // namespace gasgrain
