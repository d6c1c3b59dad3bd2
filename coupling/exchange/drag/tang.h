// Drag in random arrays of spheres from immersed-boundary simulations, after Tang, Peters and
// Kuipers.
//
//   F_d = 3 pi mu d U F,  U = eps |u - v|,  Re = eps rho |u - v| d / mu,  phi = 1 - eps
//   F = 10 phi / eps^2 + eps^2 (1 + 1.5 phi^(1/2))
//     + (0.11 phi (1 + phi) - 0.00456 / eps^4 + (0.169 eps + 0.0644 / eps^4) Re^-0.343) Re
//   K = 3 pi mu d eps F
//
// Source: Y. Tang, E.A.J.F. Peters, J.A.M. Kuipers, S.H.L. Kriebitzsch, M.A. van der Hoef,
//   AIChE J. 61 (2015) 688, eq 21.
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: F_d is the drag of model A at the SUPERFICIAL slip, as in beetstra.h, with whose
//   creeping part the law begins. Fixed monodisperse spheres.
// Range: phi 0.1 to 0.6, Re 50 to 1000; within 4 % of the simulations on average. Towards an
//   isolated sphere and creeping flow its form follows other sources.
// Deviations: above Re = 1000 the part with Re grows in proportion to Re (constant C_d). As printed
//   it bends down and becomes negative, from Re = 2700 at eps = 0.2 to Re = 95000 at eps = 1.
#pragma once

#include <algorithm>

#include "coupling/exchange/drag/beetstra.h"

namespace gasgrain {

struct DragTang {
  static constexpr std::string_view name = "tang";
  static constexpr std::string_view source = "Tang, Peters and Kuipers (2015)";
  static constexpr DragRange range{0.4, 0.9, 50.0, 1000.0};
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    return coefficient_from_superficial_drag(DragBeetstra::creeping(eps) + inertial(eps, re), gas,
                                             eps, diameter);
  }

  static double inertial(double eps, double re) {
    const double phi = 1.0 - eps;
    const double eps4 = eps * eps * eps * eps;
    // re * re_fitted^-0.343 without a division at slip 0.
    const double re_fitted = std::min(re, range.re_max);
    const double beyond = std::max(re / range.re_max, 1.0);
    const double linear = 0.11 * phi * (1.0 + phi) - 0.00456 / eps4;
    const double root = 0.169 * eps + 0.0644 / eps4;
    return beyond * (linear * re_fitted + root * std::pow(re_fitted, 1.0 - 0.343));
  }
};

}  // namespace gasgrain
