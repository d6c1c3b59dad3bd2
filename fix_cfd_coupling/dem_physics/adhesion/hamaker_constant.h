// Hamaker's constant A [J] of two materials i and j, also unlike ones and across a medium k.
//
//   in vacuum or gas            A_ij  = sqrt(A_ii A_jj)
//   across a medium             A_ikj = (sqrt A_ii - sqrt A_kk) (sqrt A_jj - sqrt A_kk)
//   of Lifshitz's constant      A = 3 / (4 pi) h_omega
//   of permittivity and index   A = 3/4 k_B T (e_i - e_k)/(e_i + e_k) (e_j - e_k)/(e_j + e_k)
//     + 3 h f / (8 sqrt 2) (n_i^2 - n_k^2) (n_j^2 - n_k^2)
//       / (sqrt(n_i^2 + n_k^2) sqrt(n_j^2 + n_k^2) (sqrt(n_i^2 + n_k^2) + sqrt(n_j^2 + n_k^2)))
//
// Source: Alobaid (2013), eqs 5.57 to 5.60; the last line, which stands for the integral of eq 5.60
//   where each material absorbs at one ultraviolet frequency f: D. Tabor, R.H.S. Winterton, Proc.
//   R. Soc. A 312 (1969) 435; J.N. Israelachvili, Intermolecular and Surface Forces, ch. 13.
// Inputs: A_ii, A_kk [J]; h_omega [J]; e relative permittivity at rest, n refractive index in the
//   visible, f [1/s] near 3e15, T [K]. Output: A [J]; above 0 the bodies attract each other, below
//   0 (a medium between the two materials) they repel each other.
// Range: the mixing rules are estimates; they are poor where a medium of high permittivity, such as
//   water, takes part. Not retarded: gaps below some 10 nm.
// Deviations: eq 5.58 has lost its square roots (its unit is J^2). Planck's constant of eq 5.60 is
//   the reduced one when the frequency is angular.
#pragma once

#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::adhesion {

inline constexpr double planck = 6.62607015e-34;    // h [J s]
inline constexpr double boltzmann = 1.380649e-23;   // k_B [J/K]
inline constexpr double gas_constant = 8.31446262;  // [J/(mol K)]

inline double hamaker_of_unlike(double a_ii, double a_jj) {
  return std::sqrt(a_ii * a_jj);
}

inline double hamaker_across(double a_ii, double a_jj, double a_medium) {
  const double medium = std::sqrt(a_medium);
  return (std::sqrt(a_ii) - medium) * (std::sqrt(a_jj) - medium);
}

inline double hamaker_of_lifshitz_constant(double h_omega) {
  return 3.0 / (4.0 * contact::pi) * h_omega;
}

struct Dielectric {
  double permittivity;      // e, relative, at rest
  double refractive_index;  // n
};

inline double hamaker_of_dielectrics(const Dielectric& i, const Dielectric& j, const Dielectric& k,
                                     double absorption, double temperature) {
  const auto contrast = [&k](const Dielectric& of) {
    return (of.permittivity - k.permittivity) / (of.permittivity + k.permittivity);
  };
  const auto square = [](double n) { return n * n; };
  const double n_k = square(k.refractive_index);
  const double n_i = square(i.refractive_index);
  const double n_j = square(j.refractive_index);
  const double root_i = std::sqrt(n_i + n_k);
  const double root_j = std::sqrt(n_j + n_k);
  const double at_rest = 0.75 * boltzmann * temperature * contrast(i) * contrast(j);
  const double dispersion = 3.0 * planck * absorption / (8.0 * std::sqrt(2.0)) * (n_i - n_k) *
                            (n_j - n_k) / (root_i * root_j * (root_i + root_j));
  return at_rest + dispersion;
}

// Throws Error unless A_ii, A_jj and A_kk are constants of one material each.
inline void check_hamaker(double a_ii, double a_jj, double a_medium) {
  constexpr auto remedy =
      "a material's own constant lies between 1e-20 and 5e-19 J; give 0 to switch the force off";
  InputFaults("The mixing rule of Hamaker's constants")
      .not_negative("A_ii", a_ii, "J", remedy)
      .not_negative("A_jj", a_jj, "J", remedy)
      .not_negative("A_kk", a_medium, "J", "give 0 for gas or vacuum")
      .refuse();
}

}  // namespace gasgrain::adhesion
