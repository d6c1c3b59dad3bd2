// Drag of an isolated sphere after Schiller and Naumann.
//
//   F_d = C_d (pi d^2 / 4) (rho |u - v|^2 / 2),  Re = rho |u - v| d / mu
//   C_d = the greater of 24 / Re (1 + 0.15 Re^0.687) and 0.44
//   K = 3 pi mu d C_d Re / 24
//
// Source: L. Schiller, A. Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318 (printed again by most later
//   laws, e.g. as the sphere of Hoomans et al. (2001)); 0.44 is Newton's value for Re up to 2e5.
// Inputs, output: as ergun_wen_yu.h; the void fraction is not used.
// Assumptions: no neighbours, so the slip is the INTERSTITIAL one and drag and total
//   force are the same.
// Range: dilute gas (eps near 1), Re up to 800 for the formula, up to 2e5 with 0.44.
// Deviations: the formula goes on to Re = 989, where it meets 0.44. Cut at 800, as the fit was, C_d
//   would fall there at once by 7 %; the laws that cut at 1000 have a step of 0.4 %.
#pragma once

#include <algorithm>
#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragSchillerNaumann {
  static constexpr std::string_view name = "schiller_naumann";
  static constexpr std::string_view source = "Schiller and Naumann (1933)";
  static constexpr DragRange range{0.99, 1.0, 0.0, 2e5};
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double /*eps*/, double slip_speed,
                            double diameter) {
    const double re = interstitial_reynolds(gas, slip_speed, diameter);
    return coefficient_from_isolated_drag(over_stokes(re), gas, diameter);
  }

  // C_d Re / 24.
  static double over_stokes(double re) {
    return std::max(1.0 + 0.15 * std::pow(re, 0.687), 0.44 * re / 24.0);
  }
};

}  // namespace gasgrain
