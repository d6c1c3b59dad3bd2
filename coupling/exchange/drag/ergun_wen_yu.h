// Drag of a dense bed after Ergun, of a dilute one after Wen and Yu, with a switch between them.
//
//   eps < 0.8:   beta = 150 (1 - eps)^2 mu / (eps d^2) + 1.75 (1 - eps) rho |u - v| / d
//   eps >= 0.8:  beta = 3/4 C_d eps (1 - eps) rho |u - v| / d eps^-2.65
//   C_d = 24 / Re (1 + 0.15 Re^0.687) for Re < 1000, 0.44 above;  Re = eps rho |u - v| d / mu
//   K = beta V_p / (1 - eps)
//
// Source: S. Ergun, Chem. Eng. Prog. 48 (1952) 89; C.Y. Wen, Y.H. Yu, Chem. Eng. Prog. Symp. Ser.
// 62
//   (1966) 100; as combined by B.P.B. Hoomans et al., Powder Technol. 116 (2001) 166, eqs 27-30.
// Inputs: gas density [kg/m3] and viscosity [Pa s], void fraction eps, slip |u - v| [m/s] between
// the
//   interstitial gas velocity and the particle, diameter [m]. Output: K [kg/s], not negative.
// Assumptions: model A, interstitial slip; Re is built with the superficial slip.
// Range: eps 0.35 to 1; Re up to 1e5 (C_d constant from 1000).
// Deviations: none from Hoomans; (1 - eps) and |u - v| are cancelled analytically so that eps = 1
// and
//   slip 0 are ordinary points. The switch is a jump, as published: at eps = 0.8 Ergun's value
//   is 1.15 times Wen and Yu's for Re = 0, 1.7 times at Re = 100, 3.8 times at Re = 1000. F.
//   Alobaid, thesis, TU Darmstadt (2013), eq 7.8, prints Wen and Yu without the factor mu / d^2;
//   with it the two sources are the same.
#pragma once

#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragErgunWenYu {
  static constexpr std::string_view name = "ergun_wen_yu";
  static constexpr std::string_view source =
      "Ergun (1952), Wen and Yu (1966), Hoomans et al. (2001)";
  static constexpr DragRange range{0.35, 1.0, 0.0, 1e5};
  // Where the published branches do not meet, and their K over 3 pi mu d at eps = 1, Re = 0.
  static constexpr std::array<double, 1> eps_switches{0.8};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    return eps < eps_switches[0] ? ergun(gas, eps, slip_speed, diameter)
                                 : wen_yu(gas, eps, slip_speed, diameter);
  }

  static double ergun(const GasProperties& gas, double eps, double slip_speed, double diameter) {
    const double viscous = 150.0 * (1.0 - eps) * gas.viscosity / (eps * diameter * diameter);
    const double inertial = 1.75 * gas.density * slip_speed / diameter;
    return coefficient_from_beta(viscous + inertial, diameter);
  }

  static double wen_yu(const GasProperties& gas, double eps, double slip_speed, double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    const double cd_re = re < 1000.0 ? 24.0 * (1.0 + 0.15 * std::pow(re, 0.687)) : 0.44 * re;
    // rho |u - v| = Re mu / (eps d) takes the slip out of the denominator of C_d.
    const double beta_per_solid_fraction =
        0.75 * cd_re * gas.viscosity / (diameter * diameter) * std::pow(eps, -2.65);
    return coefficient_from_beta(beta_per_solid_fraction, diameter);
  }
};

}  // namespace gasgrain
