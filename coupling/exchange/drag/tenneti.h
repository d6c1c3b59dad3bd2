// Drag in random arrays of spheres from immersed-boundary simulations, after Tenneti, Garg and
// Subramaniam.
//
//   F_t = 3 pi mu d U F,  U = eps |u - v|,  Re = eps rho |u - v| d / mu,  phi = 1 - eps
//   F = F_isol / eps^3 + 5.81 phi / eps^3 + 0.48 phi^(1/3) / eps^4
//     + phi^3 Re (0.95 + 0.61 phi^3 / eps^2),  F_isol = 1 + 0.15 Re^0.687
//   K = 3 pi mu d eps^2 F
//
// Source: S. Tenneti, R. Garg, S. Subramaniam, Int. J. Multiphase Flow 37 (2011) 1072.
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: F_t is the TOTAL force, with the mean pressure gradient, at the SUPERFICIAL slip,
//   hence eps^2: in creeping flow at phi = 0.4 it is 18.1, the total force of Carman's bed 18.5,
//   its drag alone 11.1. Fixed monodisperse spheres.
// Range: phi 0.1 to 0.5, Re 0.01 to 300; the form ends in an isolated sphere.
// Deviations: F_isol is the sphere of schiller_naumann.h, whose C_d is 0.44 from Re = 989.
#pragma once

#include "coupling/exchange/drag/schiller_naumann.h"

namespace gasgrain {

struct DragTenneti {
  static constexpr std::string_view name = "tenneti";
  static constexpr std::string_view source = "Tenneti, Garg and Subramaniam (2011)";
  static constexpr DragRange range{0.5, 0.9, 0.01, 300.0};
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    return coefficient_from_superficial_total(total(eps, re), gas, eps, diameter);
  }

  static double total(double eps, double re) {
    const double phi = 1.0 - eps;
    const double phi3 = phi * phi * phi;
    const double eps2 = eps * eps;
    const double eps3 = eps2 * eps;
    return (DragSchillerNaumann::over_stokes(re) + 5.81 * phi) / eps3 +
           0.48 * std::cbrt(phi) / (eps2 * eps2) + phi3 * re * (0.95 + 0.61 * phi3 / eps2);
  }
};

}  // namespace gasgrain
