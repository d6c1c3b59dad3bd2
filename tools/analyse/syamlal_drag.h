// The momentum that collisions carry from one solid phase, b, to another, s, by volume and time.
//
//   F_sb = 3 (1 + e) (pi/2 + mu pi^2/8) a_s a_b rho_s rho_b (d_s + d_b)^2 g0 |u_b - u_s|
//          / (2 pi (rho_s d_s^3 + rho_b d_b^3)) (u_b - u_s)
//   g0 = 1/a_g + 3 d_s d_b / (a_g^2 (d_s + d_b)) (a_s/d_s + a_b/d_b),  a_g = 1 - a_s - a_b
//
// Source: M. Syamlal, The particle-particle drag term in a multiparticle model of fluidization,
//   DOE/MC/21353-2373 (1987), as S. Shah, P. Jalali, Powder Technol. 363 (2020) 584 print it,
//   eq. 10. g0 is that of J. L. Lebowitz, Phys. Rev. 133 (1964) A895, the one that Syamlal takes.
// Inputs: volume fractions a [-] of the whole volume, densities [kg/m3] of the grains, diameters
// [m],
//   mean velocities [m/s], restitution e and friction mu [-] of s on b. Output: on s [N/m3]; b has
//   the opposite.
// Assumptions: spheres of one size in each phase, spread evenly over the volume; collisions of two;
//   all of a phase move alike (no fluctuations); friction slides throughout.
// Range: 0 <= a_s + a_b < 1. In the limit of few small spheres and one big one, without friction
// and
//   with g0 = 1, it is the exact force on a sphere in a beam: (1 + e) pi/8 a_s rho_s (d_s + d_b)^2
//   u^2.
// Deviations: none from the print, whose form is that of 1987. The later term for lasting contacts
//   (D. Gera, M. Syamlal, T. J. O'Brien, Int. J. Multiphase Flow 30 (2004) 419), a multiple of the
//   solids pressure beyond close packing, is not in it.
#pragma once

#include "coupling/base/vec3.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct SolidPhase {
  double fraction = 0.0;         // a
  double density = 0.0;          // kg/m3
  double diameter = 0.0;         // m
  Vec3 velocity = Vec3::Zero();  // m/s
};

// g0 of spheres of one phase that touch spheres of the other.
inline double contact_distribution(const SolidPhase& s, const SolidPhase& b) {
  const double a_g = 1.0 - s.fraction - b.fraction;
  const double d_mean = s.diameter * b.diameter / (s.diameter + b.diameter);
  return 1.0 / a_g +
         3.0 * d_mean / (a_g * a_g) * (s.fraction / s.diameter + b.fraction / b.diameter);
}

inline Vec3 syamlal_drag(const SolidPhase& s, const SolidPhase& b, double e, double mu) {
  const auto cube = [](double x) { return x * x * x; };
  const double sum = s.diameter + b.diameter;
  const Vec3 slip = b.velocity - s.velocity;
  return 3.0 * (1.0 + e) * (pi / 2.0 + mu * pi * pi / 8.0) * s.fraction * b.fraction * s.density *
         b.density * sum * sum * contact_distribution(s, b) * slip.norm() /
         (2.0 * pi * (s.density * cube(s.diameter) + b.density * cube(b.diameter))) * slip;
}

}  // namespace gasgrain
