// Gidaspow's drag law with a smooth passage from Ergun to Wen and Yu.
//
//   beta = (1 - w) beta_Ergun + w beta_WenYu,  w = 1/2 + arctan(150 1.75 (0.2 - phi)) / pi
//   K = beta V_p / phi,  phi = 1 - eps
//
// Source: L. Huilin, D. Gidaspow, Chem. Eng. Sci. 58 (2003) 3777; the weight after D. Lathouwers,
//   J. Bellan, Proc. U.S. DOE Hydrogen Program Review (2000). beta as in ergun_wen_yu.h.
// Inputs, output, assumptions, range: as ergun_wen_yu.h.
// Deviations: none. The arctangent has long tails: 0.6 % of the other law at eps = 0.6 and 1. An
//   isolated sphere in creeping flow feels 1 - arctan(1 / 52.5) / pi = 0.9939 of Stokes' drag.
#pragma once

#include "coupling/exchange/drag/ergun_wen_yu.h"

namespace gasgrain {

struct DragGidaspowBlend {
  static constexpr std::string_view name = "gidaspow_blend";
  static constexpr std::string_view source = "Huilin and Gidaspow (2003)";
  static constexpr DragRange range = DragErgunWenYu::range;
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 0.99393768763743;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double w = weight_of_wen_yu(eps);
    return (1.0 - w) * DragErgunWenYu::ergun(gas, eps, slip_speed, diameter) +
           w * DragErgunWenYu::wen_yu(gas, eps, slip_speed, diameter);
  }

  static double weight_of_wen_yu(double eps) {
    return 0.5 + std::atan(150.0 * 1.75 * (eps - 0.8)) / pi;
  }
};

}  // namespace gasgrain
