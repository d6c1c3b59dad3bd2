// The standard k-epsilon model at a point: its constants, its eddy viscosity and its wall law.
//
//   mu_t = C_mu rho k^2 / e
//   y* = C_mu^(1/4) k^(1/2) y rho / mu
//   u* = y* where y* is less than the crossing, else ln(E y*) / kappa
//   tau_w = rho C_mu^(1/4) k^(1/2) u / u*                        (mu u / y on the viscous branch)
//   mean dissipation from the wall to y: C_mu^(3/4) k^(3/2) u* / y
//   dissipation at y:                    C_mu^(3/4) k^(3/2) / (kappa y)
//
// k [m2/s2], e [m2/s3], mu [Pa s]; y is the distance of the wall cell's centre, u the gas' velocity
// along the wall there, relative to the wall.
//
// Source: B. E. Launder, D. B. Spalding, Comput. Methods Appl. Mech. Eng. 3 (1974) 269: the model
// and its constants; the wall law with C_mu^(1/4) k^(1/2) for the friction velocity; the integral
// of e over the wall's cell. In equilibrium tau_w = rho C_mu^(1/2) k, and then the mean production
// tau_w u / y equals the mean dissipation: the relations are consistent with each other.
// kappa = 0.41, E = 9.8: the usual values of a smooth wall; others are in use (0.4187, 9.793).
// The mean from the wall to y stands for the whole cell, whose height is 2 y, as in their programs.
// Below the crossing u* = y* continues the same relations, as in the TEACH programs (Gosman and
// Ideriah 1976): continuous, and k there tends to tau_w / (rho C_mu^(1/2)) all the same.
// Range: meant for 30 < y* < 300; below the crossing the model itself (of high Reynolds numbers)
// does not hold.
#pragma once

#include <cmath>

namespace gasgrain::launder_spalding {

inline constexpr double c_mu = 0.09;
inline constexpr double c_1 = 1.44;
inline constexpr double c_2 = 1.92;
inline constexpr double sigma_k = 1.0;
inline constexpr double sigma_e = 1.3;
inline constexpr double kappa = 0.41;
inline constexpr double wall_e = 9.8;             // of a smooth wall
inline constexpr double crossing = 11.530107402;  // y = ln(E y) / kappa

inline const double c_mu_25 = std::pow(c_mu, 0.25);
inline const double c_mu_75 = std::pow(c_mu, 0.75);

inline double eddy_viscosity(double density, double k, double e) {
  return c_mu * density * k * k / e;
}

// e of turbulence of the length scale l = C_mu^(3/4) k^(3/2) / e [m].
inline double dissipation(double k, double length) {
  return c_mu_75 * k * std::sqrt(k) / length;
}

inline double wall_distance(double density, double viscosity, double k, double y) {
  return c_mu_25 * std::sqrt(k) * y * density / viscosity;
}

inline double wall_velocity(double y_star) {
  return y_star < crossing ? y_star : std::log(wall_e * y_star) / kappa;
}

// tau_w / u [Pa s/m].
inline double wall_coefficient(double density, double viscosity, double k, double y) {
  const double y_star = wall_distance(density, viscosity, k, y);
  if (y_star < crossing) return viscosity / y;
  return density * c_mu_25 * std::sqrt(k) / wall_velocity(y_star);
}

// Mean dissipation from the wall to y, per k [1/s].
inline double wall_dissipation_rate(double density, double viscosity, double k, double y) {
  return c_mu_75 * std::sqrt(k) * wall_velocity(wall_distance(density, viscosity, k, y)) / y;
}

}  // namespace gasgrain::launder_spalding
