// Drag of an isolated sphere times a power of the void fraction, after Di Felice.
//
//   F_d = C_d (pi d^2 / 4) (rho U^2 / 2) eps^-beta,  U = eps |u - v|,  Re = rho U d / mu
//   C_d = (0.63 + 4.8 / Re^(1/2))^2
//   beta = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)
//   K = 3 pi mu d eps^(1 - beta) C_d Re / 24
//
// Source: R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153; C_d after J.M. Dallavalle,
//   Micromeritics (1948).
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: F_d is the drag of model A at the SUPERFICIAL slip U. It is what a suspension in
//   equilibrium needs beside the pressure gradient, F_d = eps V_p (rho_p - rho) g: with Stokes'
//   drag that is U ~ eps^(1 + beta) = eps^4.7, the law of Richardson and Zaki. Written with
//   interstitial slip the force is C_d (pi d^2 / 8) rho |u - v|^2 eps^(2 - beta). The total force,
//   model B, would be F_d / eps; codes that take U for the interstitial slip, or F_d for the total
//   force, differ from this one by eps^2 and by eps.
// Range: eps 0.4 to 1, Re up to 1e4.
// Deviations: C_d Re is expanded so that slip 0 is an ordinary point. As published, creeping flow
//   around an isolated sphere gives 0.96 of Stokes' drag. In a dense bed K falls slightly with Re
//   around Re = 1 (through beta); the force K |u - v| always grows.
#pragma once

#include <algorithm>
#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragDiFelice {
  static constexpr std::string_view name = "di_felice";
  static constexpr std::string_view source = "Di Felice (1994)";
  static constexpr DragRange range{0.4, 1.0, 0.0, 1e4};
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 4.8 * 4.8 / 24.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    const double root_cd_re = 0.63 * std::sqrt(re) + 4.8;
    const double f = root_cd_re * root_cd_re / 24.0 * std::pow(eps, -exponent(re));
    return coefficient_from_superficial_drag(f, gas, eps, diameter);
  }

  static double exponent(double re) {
    // Below this beta is 3.7 to round-off; the logarithm needs a number.
    constexpr double least_re = 1e-12;
    const double distance = 1.5 - std::log10(std::max(re, least_re));
    return 3.7 - 0.65 * std::exp(-0.5 * distance * distance);
  }
};

}  // namespace gasgrain
