// How long two spheres that collide head-on touch, and how deep; and what that asks of the DEM
// step.
//
// Normal contact, overlap delta [m] > 0, delta' = v when it begins, over when delta is 0 again:
//   Hertz   m delta'' + gamma(delta) delta' + k delta^(3/2) = 0,   k = 4/3 E* sqrt(R*) [N/m^(3/2)]
//           gamma = sqrt(5) zeta sqrt(m k) delta^(1/4)
//   linear  m delta'' + 2 zeta sqrt(m k) delta' + k delta = 0,     k [N/m]
//   zeta = -ln e / sqrt(ln^2 e + pi^2), e the coefficient of restitution
// These are the normal models `hertz` and `hooke` of LIGGGHTS 3.8 (normal_model_hertz.h,
// normal_model_hooke.h), whose gamma_n = 2 sqrt(5/6) zeta sqrt(S_n m), S_n = 2 E* sqrt(R* delta),
// is the gamma above. Both give e exactly, whatever the speed.
//
// Sources: Hertz's contact, its duration and depth: Landau and Lifshitz, Theory of Elasticity, 9.
// Damping: Tsuji, Tanaka and Ishida, Powder Technol. 71 (1992) 239. With y = 4/5 delta^(5/4) and
// d sigma = delta^(1/4) dt the damped Hertz contact is the linear one (Antypov and Elliott,
// EPL 94 (2011) 50004, eqs 8-14); hertz_duration() integrates dt = delta^(-1/4) d sigma over it.
// Rayleigh's wave: Thornton and Randall, in Micromechanics of Granular Materials (1988) 133.
//
// Units: SI. m, R*, E* are the pair's: two equal spheres of mass M and radius R have m = M/2,
// R* = R/2; a sphere on a wall m = M, R* = R.
// Assumes: no adhesion, no third sphere, no rotation; e in (0, 1], v > 0.
#pragma once

#include <cmath>
#include <limits>

namespace gasgrain::contact {

inline constexpr double pi = 3.14159265358979323846;

// A pair's mass or radius: a b / (a + b).
inline double effective(double a, double b) {
  return a * b / (a + b);
}

// E* [Pa] of Young's moduli and Poisson's ratios.
inline double effective_modulus(double youngs_a, double poisson_a, double youngs_b,
                                double poisson_b) {
  return 1.0 /
         ((1.0 - poisson_a * poisson_a) / youngs_a + (1.0 - poisson_b * poisson_b) / youngs_b);
}

// zeta of the coefficient of restitution: 0 of e = 1, towards 1 of e = 0.
inline double damping_ratio(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(log_e * log_e + pi * pi);
}

// ------------------------------------------------------------------------------------ Hertz

// k [N/m^(3/2)] of the force k delta^(3/2).
inline double hertz_stiffness(double modulus, double radius) {
  return 4.0 / 3.0 * modulus * std::sqrt(radius);
}

// Greatest overlap [m] of a collision at `speed` without damping; with damping it is less.
inline double hertz_greatest_overlap(double k, double mass, double speed) {
  return std::pow(1.25 * mass * speed * speed / k, 0.4);
}

// The spring that its stiffness is at this overlap, dF/d delta [N/m].
inline double hertz_tangent_stiffness(double k, double overlap) {
  return 1.5 * k * std::sqrt(overlap);
}

// Duration [s]. Without damping 2.943 greatest overlap / speed; damping lengthens it.
//   t = (4 / (5 v))^(1/5) omega_d^(-4/5) integral_0^pi exp(-ln e theta / (5 pi)) sin^(-1/5) theta
//   omega_d^2 = 5/4 k / m (1 - zeta^2)
// The integral's ends, theta^(-1/5), become smooth with theta = pi/2 s^5; Simpson's rule with 256
// intervals is right to 2e-9.
inline double hertz_duration(double k, double mass, double speed, double restitution = 1.0) {
  const double zeta = damping_ratio(restitution);
  const double omega = std::sqrt(1.25 * k / mass * (1.0 - zeta * zeta));
  const double growth = -std::log(restitution) / (5.0 * pi);
  const auto integrand = [growth](double s) {
    const double theta = 0.5 * pi * std::pow(s, 5);
    // sin^(-1/5) theta d theta / ds goes to 0 with s^3
    const double both_halves = std::exp(growth * theta) + std::exp(growth * (pi - theta));
    const double sine = s > 0.0 ? std::pow(std::sin(theta), -0.2) * 2.5 * pi * std::pow(s, 4) : 0.0;
    return both_halves * sine;
  };
  constexpr int intervals = 256;
  double sum = integrand(0.0) + integrand(1.0);
  for (int n = 1; n < intervals; ++n)
    sum += (n % 2 == 1 ? 4.0 : 2.0) * integrand(static_cast<double>(n) / intervals);
  const double integral = sum / (3.0 * intervals);
  return std::pow(0.8 / speed, 0.2) * std::pow(omega, -0.8) * integral;
}

// ----------------------------------------------------------------------------------- linear

// k [N/m] that LIGGGHTS's `hooke` takes: at `characteristic_velocity` as much energy is stored at
// the same greatest overlap as in Hertz's contact.
inline double hooke_stiffness(double modulus, double radius, double mass,
                              double characteristic_velocity) {
  const double root = std::sqrt(radius) * modulus;
  return 16.0 / 15.0 * root *
         std::pow(15.0 * mass * characteristic_velocity * characteristic_velocity / (16.0 * root),
                  0.2);
}

inline double linear_greatest_overlap(double k, double mass, double speed) {
  return speed * std::sqrt(mass / k);
}

// Duration [s] of a spring k with a dashpot gamma [N s/m]; infinite when it creeps back.
inline double linear_duration_of_dashpot(double k, double mass, double gamma) {
  const double square = k / mass - gamma * gamma / (4.0 * mass * mass);
  return square > 0.0 ? pi / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

inline double linear_duration(double k, double mass, double restitution = 1.0) {
  return linear_duration_of_dashpot(k, mass,
                                    2.0 * damping_ratio(restitution) * std::sqrt(k * mass));
}

// ------------------------------------------------------------------------------- other times

inline double shear_modulus(double youngs, double poisson) {
  return youngs / (2.0 * (1.0 + poisson));
}

// Time [s] in which Rayleigh's wave runs over a sphere, from pole to pole.
inline double rayleigh_time(double radius, double density, double shear, double poisson) {
  return pi * radius * std::sqrt(density / shear) / (0.1631 * poisson + 0.8766);
}

}  // namespace gasgrain::contact
