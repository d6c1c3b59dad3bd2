// The greatest size of the electrostatic force between two grains.
//
//   F = q^2 / (4 pi eps0 d^2),   q = pi d^2 eps0 E_b,   number: F / (m g)
//
// q is the charge at which air breaks down at the grain's surface, E_b = 3e6 V/m: no grain in air
// has more, most have a hundredth. Source: Coulomb's and Gauss's laws. Inputs: d, weight.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeElectrostatics {
  static constexpr std::string_view name = "electrostatics";
  static constexpr std::string_view number_name = "q^2 / (4 pi eps0 d^2 m g)";
  static constexpr std::string_view threshold =
      "0.05 at the charge of breakdown, which few grains have; thesis 8.1.1: named as a cause of "
      "error";

  static double number(const Scales& at) { return ratio(force(at), at.weight()); }
  static double force(const Scales& at) {
    constexpr double vacuum = 8.854e-12;  // eps0 [F/m]
    constexpr double breakdown = 3e6;     // E_b [V/m]
    return 0.25 * pi * vacuum * breakdown * breakdown * at.diameter * at.diameter;
  }
};

}  // namespace gasgrain
