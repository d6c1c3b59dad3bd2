// What the estimates of this folder start from: the scales of one place in a flow (a bed, a jet),
// or of one grain in it. SI; magnitudes, none negative. What is not known or not there is 0, and an
// effect that depends on it then has the size 0.
#pragma once

#include <algorithm>
#include <limits>

#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct Scales {
  // Of the grain
  double diameter = 0.0;            // d [m]
  double solid_density = 0.0;       // rho_p [kg/m3]
  double speed = 0.0;               // v [m/s]
  double spin = 0.0;                // omega_p [rad/s]
  double grain_acceleration = 0.0;  // dv/dt [m/s2]
  double gravity = 0.0;             // g [m/s2]
  double drag = 0.0;                // K (u - v) [N], by the scene's law
  // Of the grains together
  double void_fraction = 1.0;      // eps
  double smallest_diameter = 0.0;  // [m]
  double sauter_diameter = 0.0;    // six times the volume over the surface of all [m]
  double speed_scatter = 0.0;      // of grains beside each other, v' [m/s]
  double friction = 0.0;           // coefficient between grains
  double bed_height = 0.0;         // H [m]
  // Of the gas, at the grain
  double gas_density = 0.0;        // rho [kg/m3]
  double viscosity = 0.0;          // mu [Pa s]
  double slip = 0.0;               // U = |u - v|, interstitial [m/s]
  double vorticity = 0.0;          // w = |curl u| [1/s]
  double gas_acceleration = 0.0;   // |Du/Dt| [m/s2]
  double pressure_gradient = 0.0;  // |grad p| [Pa/m]
  double viscous_force = 0.0;      // |div tau| [N/m3]
  // Of the gas as a whole
  double gas_speed = 0.0;      // u [m/s]
  double gas_length = 0.0;     // l over which u varies [m]
  double pressure_drop = 0.0;  // over the bed [Pa]
  double gas_pressure = 0.0;   // absolute [Pa]
  // Of the numerics
  double cell = 0.0;      // h, geometric mean [m]
  double interval = 0.0;  // T of the coupling [s]
  double depth = 0.0;     // of a grid one cell deep [m], else 0
  double smagorinsky_constant = 0.1;
  double bell = 0.0;  // standard deviation of a grain's weights, the grid's share included [m]
  // Of fields from outside
  double charge = 0.0;    // q [C]
  double electric = 0.0;  // E [V/m]
  double magnetic = 0.0;  // B [T]

  [[nodiscard]] double radius() const { return 0.5 * diameter; }
  [[nodiscard]] double volume() const { return sphere_volume(radius()); }
  [[nodiscard]] double mass() const { return solid_density * volume(); }
  [[nodiscard]] double weight() const { return mass() * gravity; }
  [[nodiscard]] double solids() const { return 1.0 - void_fraction; }
  // Of a force of the gas that is given per volume of the gas [N/m3]: that on one grain's share
  // [N].
  [[nodiscard]] double per_grain(double force_density) const {
    constexpr double dilute = 1e-3;  // with fewer solids the gas of a grain is no share of it
    return force_density * volume() / std::max(solids(), dilute);
  }
  // Of the relative motion; the two need not have one direction, so this is the greatest.
  [[nodiscard]] double relative_acceleration() const {
    return gas_acceleration + grain_acceleration;
  }
  // Of the grain against the gas, Omega.
  [[nodiscard]] double turn() const { return 0.5 * vorticity + spin; }
  [[nodiscard]] double reynolds() const {
    return viscosity > 0.0 ? gas_density * slip * diameter / viscosity : 0.0;
  }
};

// a / b, and 0 of 0 / 0.
inline double ratio(double a, double b) {
  if (a == 0.0) return 0.0;
  return b > 0.0 ? a / b : std::numeric_limits<double>::infinity();
}

// An effect that is less than this share of what moves a grain, the greater of weight and drag, is
// not needed. The laws of the drag LIST differ by 20 to 40 % from each other (docs/exchange.md):
// what is below a quarter of the least of that is not seen beside the choice of a law.
inline constexpr double needed_share = 0.05;

// The share of the greater of weight and drag that a force [N] is.
inline double share_of_motion(const Scales& at, double force) {
  return ratio(force, std::max(at.weight(), at.drag));
}

}  // namespace gasgrain
