// Drag in random arrays of spheres from lattice-Boltzmann simulations, after Beetstra, van der Hoef
// and Kuipers.
//
//   F_d = 3 pi mu d U F,  U = eps |u - v|,  Re = eps rho |u - v| d / mu,  phi = 1 - eps
//   F = 10 phi / eps^2 + eps^2 (1 + 1.5 phi^(1/2))
//     + 0.413 Re / (24 eps^2) (1 / eps + 3 phi eps + 8.4 Re^-0.343) / (1 + 10^(3 phi) Re^-m)
//   m = (1 + 4 phi) / 2
//   K = 3 pi mu d eps F
//
// Source: R. Beetstra, M.A. van der Hoef, J.A.M. Kuipers, AIChE J. 53 (2007) 489; the
//   creeping part after M.A. van der Hoef, R. Beetstra, J.A.M. Kuipers, J. Fluid Mech. 528 (2005)
//   233.
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: F_d is the drag of model A at the SUPERFICIAL slip: its first term is Carman's bed
//   without the pressure gradient, 10 phi / eps^2, where the total force has 10 phi / eps^3.
//   Monodisperse; for mixtures see polydisperse.h.
// Range: phi 0.1 to 0.6, Re up to 1000; within 10 % of the simulations on average. Towards a single
//   sphere it is too high, 1.16 of Schiller and Naumann's at Re = 100, 1.6 at Re = 1000.
// Deviations: powers of Re are collected so that slip 0 is an ordinary point. Codes that
//   multiply by eps^2, as for the total force of koch_hill.h, have a drag too small by eps.
#pragma once

#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragBeetstra {
  static constexpr std::string_view name = "beetstra";
  static constexpr std::string_view source = "Beetstra, van der Hoef and Kuipers (2007)";
  static constexpr DragRange range{0.4, 0.9, 0.0, 1000.0};
  static constexpr std::array<double, 0> eps_switches{};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    return coefficient_from_superficial_drag(creeping(eps) + inertial(eps, re), gas, eps, diameter);
  }

  static double creeping(double eps) {
    const double phi = 1.0 - eps;
    const double eps2 = eps * eps;
    return 10.0 * phi / eps2 + eps2 * (1.0 + 1.5 * std::sqrt(phi));
  }

  static double inertial(double eps, double re) {
    const double phi = 1.0 - eps;
    const double re_m = std::pow(re, 0.5 + 2.0 * phi);
    const double fade_in = re_m / (re_m + std::pow(10.0, 3.0 * phi));
    const double growth = (1.0 / eps + 3.0 * phi * eps) * re + 8.4 * std::pow(re, 1.0 - 0.343);
    return 0.413 / (24.0 * eps * eps) * growth * fade_in;
  }
};

}  // namespace gasgrain
