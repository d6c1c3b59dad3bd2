// Drag in random arrays of spheres from lattice-Boltzmann simulations, after Hill, Koch and Ladd:
// the full law, with its regimes of Reynolds number and solid fraction.
//
//   F_t = 3 pi mu d U F,  U = eps |u - v|,  R = eps rho |u - v| d / (2 mu),  phi = 1 - eps
//   F = 1 + 3/8 R       phi <= 0.01 and R <= (F2 - 1) / (3/8 - F3)
//     = F0 + F1 R^2     phi > 0.01 and R <= (F3 + (F3^2 - 4 F1 (F0 - F2))^(1/2)) / (2 F1)
//     = F2 + F3 R       else
//   F0 = (1 - w) (1 + 3 (phi/2)^(1/2) + 135/64 phi ln phi + 17.14 phi)
//        / (1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3) + w 10 phi / eps^3
//   F1 = (2 / phi)^(1/2) / 40                   phi <= 0.1
//      = 0.11 + 0.00051 exp(11.6 phi)           phi > 0.1
//   F2 as F0 with 17.89, -11.03 and 15.41 in place of 17.14, -8.48 and 8.16
//   F3 = 0.9351 phi + 0.03667                   phi < 0.0953
//      = 0.0673 + 0.212 phi + 0.0232 / eps^5    phi >= 0.0953
//   w = exp(-10 (0.4 - phi) / phi), 1 from phi = 0.4
//   K = 3 pi mu d eps^2 F
//
// Source: R.J. Hill, D.L. Koch, A.J.C. Ladd, J. Fluid Mech. 448 (2001) 213 and 243; joined to one
//   law for all R and phi by S. Benyahia, M. Syamlal, T.J. O'Brien, Powder Technol. 162 (2006) 166.
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: F_t is the TOTAL force at the SUPERFICIAL slip, hence eps^2; Re is built with the
//   RADIUS. Fixed monodisperse spheres.
// Range: phi 0.01 to 0.64, Re of the diameter up to 200. For a single sphere it is too low: 2.8 of
//   Stokes' drag at Re = 100, where Schiller and Naumann have 4.5.
// Deviations: none. As published the law steps by 28 % at phi = 0.01 in creeping flow, since F is 1
//   below, and by 0.01 % at phi = 0.1; in R it is continuous. koch_hill.h is the linear half of it,
//   used for all R; from phi = 0.4 and R = F3 / F1 (Re = 5.5 at phi = 0.4) the two are the same.
#pragma once

#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragHillKochLadd {
  static constexpr std::string_view name = "hill_koch_ladd";
  static constexpr std::string_view source =
      "Hill, Koch and Ladd (2001), Benyahia, Syamlal and O'Brien (2006)";
  static constexpr DragRange range{0.36, 0.99, 0.0, 200.0};
  static constexpr std::array<double, 2> eps_switches{0.9, 0.99};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re_of_radius = 0.5 * superficial_reynolds(gas, eps, slip_speed, diameter);
    return coefficient_from_superficial_total(total(eps, re_of_radius), gas, eps, diameter);
  }

  static double total(double eps, double r) {
    const double phi = 1.0 - eps;
    const double F2 = at_rest(phi, 17.89, -11.03, 15.41);
    const double F3 = f3(phi);
    const double linear = F2 + F3 * r;
    if (eps >= eps_switches[1]) {
      const double change = (F2 - 1.0) / (0.375 - F3);
      return r <= change ? 1.0 + 0.375 * r : linear;
    }
    const double F0 = at_rest(phi, 17.14, -8.48, 8.16);
    const double F1 = f1(eps);
    const double change = (F3 + std::sqrt(F3 * F3 - 4.0 * F1 * (F0 - F2))) / (2.0 * F1);
    return r <= change ? F0 + F1 * r * r : linear;
  }

  // F0 and F2 differ in three numbers.
  static double at_rest(double phi, double a, double b, double c) {
    const double eps = 1.0 - phi;
    const double carman = 10.0 * phi / (eps * eps * eps);
    if (phi >= 0.4) return carman;
    if (phi <= 0.0) return 1.0;
    const double w = std::exp(-10.0 * (0.4 - phi) / phi);
    const double dilute =
        (1.0 + 3.0 * std::sqrt(0.5 * phi) + 135.0 / 64.0 * phi * std::log(phi) + a * phi) /
        (1.0 + phi * (0.681 + phi * (b + phi * c)));
    return (1.0 - w) * dilute + w * carman;
  }

  static double f1(double eps) {
    const double phi = 1.0 - eps;
    return eps >= eps_switches[0] ? std::sqrt(2.0 / phi) / 40.0
                                  : 0.11 + 5.1e-4 * std::exp(11.6 * phi);
  }

  static double f3(double phi) {
    if (phi < 0.0953) return 0.9351 * phi + 0.03667;
    const double eps = 1.0 - phi;
    const double eps2 = eps * eps;
    return 0.0673 + 0.212 * phi + 0.0232 / (eps2 * eps2 * eps);
  }
};

}  // namespace gasgrain
