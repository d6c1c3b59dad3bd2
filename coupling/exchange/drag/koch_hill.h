// Drag in random arrays of spheres from lattice-Boltzmann simulations, after Hill, Koch and Ladd.
//
//   F_t = 3 pi mu d U (F0 + F3 Re / 2),  U = eps |u - v|,  Re = eps rho |u - v| d / mu,  phi = 1 -
//   eps F0 = (1 + 3 (phi/2)^(1/2) + 135/64 phi ln phi + 16.14 phi)
//        / (1 + 0.681 phi - 8.48 phi^2 + 8.16 phi^3)            phi < 0.4
//      = 10 phi / eps^3                                         phi >= 0.4
//   F3 = 0.0673 + 0.212 phi + 0.0232 / eps^5
//   K = 3 pi mu d eps^2 (F0 + F3 Re / 2)
//
// F_t is the total force (Carman's bed: -grad p = n F_t gives F0 = 10 phi / eps^3), hence eps^2,
// see basis.h. The half is there because the authors build Re with the radius.
//
// With beta = K (1 - eps) / V_p this is the form of the thesis below,
//   beta = mu / d^2 (A phi^2 / eps + B phi Re),  A = 18 eps^3 F0 / phi (180 for phi >= 0.4),
//   B = 9 eps^2 F3 = 0.6057 eps^2 + 1.908 phi eps^2 + 0.209 eps^-3.
//
// Source: R.J. Hill, D.L. Koch, A.J.C. Ladd, J. Fluid Mech. 448 (2001) 213 and 243; D.L. Koch, R.J.
//   Hill, Annu. Rev. Fluid Mech. 33 (2001) 619; F. Alobaid, thesis, TU Darmstadt (2013),
//   eqs 7.11-7.12.
// Inputs, output: as ergun_wen_yu.h.
// Assumptions: model A, interstitial slip; monodisperse spheres.
// Range: phi up to 0.64; Re 40 to 200 for the linear term, which is used for all Re.
// Deviations: the thesis prints 0.6057 (1 - eps)^2 in B; the factor is eps^2, as F3 shows. Below
//   Re = 40 the authors give F0 + F1 Re^2 / 4 instead, which starts more gently; common practice,
//   the thesis included, is the one linear law. 16.14 is the number of the Annu. Rev. paper and of
//   the thesis; the expansion for small phi would ask for 17.14 (Benyahia et al., Powder Technol.
//   162 (2006) 166), at most 5 % more. F0 steps up by 1.0 % at phi = 0.4, as published.
#pragma once

#include <array>

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

struct DragKochHill {
  static constexpr std::string_view name = "koch_hill";
  static constexpr std::string_view source = "Hill, Koch and Ladd (2001)";
  static constexpr DragRange range{0.36, 1.0, 0.0, 200.0};
  static constexpr std::array<double, 1> eps_switches{0.6};
  static constexpr double stokes_limit = 1.0;

  static double coefficient(const GasProperties& gas, double eps, double slip_speed,
                            double diameter) {
    const double re = superficial_reynolds(gas, eps, slip_speed, diameter);
    return coefficient_from_superficial_total(f0(eps) + 0.5 * f3(eps) * re, gas, eps, diameter);
  }

  // Force over Stokes' at vanishing Re.
  static double f0(double eps) {
    const double phi = 1.0 - eps;
    if (eps <= eps_switches[0]) return 10.0 * phi / (eps * eps * eps);
    const double phi_ln_phi = phi > 0.0 ? phi * std::log(phi) : 0.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * phi) + 135.0 / 64.0 * phi_ln_phi + 16.14 * phi) /
           (1.0 + phi * (0.681 + phi * (-8.48 + phi * 8.16)));
  }

  // Growth of that force with the Reynolds number of the radius.
  static double f3(double eps) {
    const double eps2 = eps * eps;
    return 0.0673 + 0.212 * (1.0 - eps) + 0.0232 / (eps2 * eps2 * eps);
  }
};

}  // namespace gasgrain
