// What a particle's own drag does to the gas velocity that it then sees, and how that is undone.
//
// Drag laws take the velocity of gas undisturbed by the particle. In a two-way coupled cell the
// gas has lost the particle's own drag, and the particle sees
//
//   u_seen = u - R f,   f = K (u - v) = K' (u_seen - v),   K' = K / (1 - K R)
//
// with K at the undisturbed slip, (u_seen - v) / (1 - K R). R is the steady answer of the gas to a
// unit force spread over a bell of variance s^2 (what is given) and read off over the same bell
// (what is seen), in a stream of slip U (Oseen's equations):
//
//   R = 1 / (6 pi^(3/2) mu s (1 + 4 / (3 pi^(1/2)) rho U s / mu))
//
// Both limits are exact: Stokes' 1 / (6 pi^(3/2) mu s), and the wake's 1 / (8 pi rho U s^2); in
// between this is within 6 % of the integral over all wave vectors.
//
// The bell's variances along the axes are those of the particle's weights, and what the grid adds:
// h^2 / 32, with which 1 / (4 pi^(3/2) s) is Green's function of the discrete Laplacian at its
// origin, 0.2527 / h; and along the force h^2 / 4, since a cell gives and takes by the mean of its
// two faces. s of Stokes' part is the geometric mean of the three, s^2 of the wake the product of
// the two standard deviations across the stream.
//
// In a bed this is not to be undone: laws for beds take the mean velocity, in which everybody's
// disturbance is counted. `alone` is 1 for a single particle and falls to 0 as others are near:
//
//   alone = 1 / (1 + (phi_others / 0.01)^2),   phi_others = 1 - eps - phi_own
//
// and, the same way, the particle's own solids are no neighbours: the law's eps is that seen plus
// alone phi_own.
//
// Sources: C.W. Oseen, Ark. Mat. Astron. Fys. 6 no. 29 (1910); for bells of a finite width
//   S. Balachandar, K. Liu, M. Lakhote, J. Comput. Phys. 376 (2019) 160; that the seen velocity is
//   to be corrected: J.A.K. Horwitz, A. Mani, J. Comput. Phys. 318 (2016) 85. The derivation is
//   ours.
// Inputs: SI. Assumptions: far from walls against s; the particle crosses s in a time that is long
//   against the coupling interval and short against its own relaxation time.
// Range: K R up to `greatest_share`, beyond which it is cut and counted: cells so much smaller than
//   the particle need a wider method (kernel).
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/base/vec3.h"
#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

// The weights of a particle.
struct Footprint {
  Vec3 variance = Vec3::Zero();  // of the cells' centres with the weights, along each axis [m2]
  Vec3 h = Vec3::Ones();         // sizes of a cell [m]
};

inline constexpr double greatest_share = 0.5;         // of K R
inline constexpr double solids_of_neighbours = 0.01;  // at which half of the correction is left

// Solid fraction that a particle of this volume [m3] sees of itself: sum of w^2 times volume over
// that of a cell, for a bell.
inline double own_solid_fraction(double volume, const Footprint& footprint) {
  double bell = 8.0 * std::pow(pi, 1.5);
  for (int d = 0; d < 3; ++d)
    bell *= std::sqrt(footprint.variance[d] + footprint.h[d] * footprint.h[d] / 12.0);
  return volume / bell;
}

inline double alone(double solids_of_others) {
  const double near = std::max(0.0, solids_of_others) / solids_of_neighbours;
  return 1.0 / (1.0 + near * near);
}

// R [s/kg] for slips of one direction: 1 / (at_rest + with_speed |slip|).
struct DisturbancePerForce {
  double at_rest = 0.0;     // [kg/s]
  double with_speed = 0.0;  // [kg/m]

  DisturbancePerForce(const GasProperties& gas, const Footprint& footprint, const Vec3& slip) {
    const Vec3 h2 = footprint.h.cwiseProduct(footprint.h);
    const Vec3 bell = footprint.variance + h2 / 32.0;
    const double square = slip.squaredNorm();
    const Vec3 along =
        square > 0.0 ? Vec3(slip.cwiseProduct(slip) / square) : Vec3(Vec3::Constant(1.0 / 3.0));
    const double across = std::sqrt(bell.prod() / along.dot(bell));
    const double lengthwise = along.dot(bell) + 0.25 * along.dot(h2);
    const double s = std::pow(lengthwise * across * across, 1.0 / 6.0);
    const double stokes = 6.0 * std::pow(pi, 1.5);
    at_rest = stokes * gas.viscosity * s;
    with_speed = stokes * 4.0 / (3.0 * std::sqrt(pi)) * gas.density * across;
  }
  [[nodiscard]] double at(double speed) const { return 1.0 / (at_rest + with_speed * speed); }
};

// R [s/kg] at the undisturbed slip [m/s].
inline double disturbance_per_force(const GasProperties& gas, const Footprint& footprint,
                                    const Vec3& slip) {
  return DisturbancePerForce(gas, footprint, slip).at(slip.norm());
}

}  // namespace gasgrain
