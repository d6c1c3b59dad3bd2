// The one place where drag laws of different velocity bases and force splits become
//
//   F_drag = K (u - v),   K [kg/s], u the INTERSTITIAL gas velocity, MODEL A:
//
// the force of the pressure gradient, -V_p grad p, acts on the particle beside it. For a uniform
// bed at rest the gas balance of model A reads -eps grad p = beta (u - v) with beta = n K, n = (1 -
// eps) / V_p particles per volume, hence K = beta V_p / (1 - eps).
//
// How the other quantities of the literature relate to K in such a bed (U = eps |u - v|,
// superficial):
//   drag of model A            F_d = K |u - v|
//   total force of the fluid   F_t = -grad p V_p / (1 - eps) = F_d / eps   (drag and pressure
//   gradient)
#pragma once

#include <cmath>
#include <string_view>

#include "coupling/exchange/sphere.h"

namespace gasgrain {

struct GasProperties {
  double density;    // [kg/m3]
  double viscosity;  // dynamic [Pa s]
  // Model B: the gas carries the whole pressure gradient, grains feel their buoyancy of it only,
  // and the drag coefficient is that of model A over eps (both then give the same force in a bed at
  // rest).
  bool whole_pressure_gradient = false;
};

// Void fractions and Reynolds numbers that a law was fitted to (its own Reynolds number).
struct DragRange {
  double eps_min;
  double eps_max;
  double re_min;
  double re_max;
};

// K of an isolated sphere in creeping flow [kg/s].
inline double stokes_coefficient(const GasProperties& gas, double diameter) {
  return 3.0 * pi * gas.viscosity * diameter;
}

// Re = eps rho |u - v| d / mu, with the superficial slip.
inline double superficial_reynolds(const GasProperties& gas, double eps, double slip_speed,
                                   double diameter) {
  return eps * gas.density * slip_speed * diameter / gas.viscosity;
}

// Re = rho |u - v| d / mu, with the interstitial slip: that of a sphere which stands alone.
inline double interstitial_reynolds(const GasProperties& gas, double slip_speed, double diameter) {
  return gas.density * slip_speed * diameter / gas.viscosity;
}

// From beta / (1 - eps) [kg/(m3 s)] of model A and the interstitial slip.
inline double coefficient_from_beta(double beta_per_solid_fraction, double diameter) {
  return beta_per_solid_fraction * sphere_volume(0.5 * diameter);
}

// From the drag of an isolated sphere in units of Stokes' drag: F_d = 3 pi mu d |u - v| f. There is
// no bed, so its slip is the interstitial one and the total force is the drag.
inline double coefficient_from_isolated_drag(double f, const GasProperties& gas, double diameter) {
  return stokes_coefficient(gas, diameter) * f;
}

// From the drag of model A in units of Stokes' drag at the superficial slip: F_d = 3 pi mu d U f.
inline double coefficient_from_superficial_drag(double f, const GasProperties& gas, double eps,
                                                double diameter) {
  return stokes_coefficient(gas, diameter) * eps * f;
}

// From the TOTAL force in the same units: F_t = 3 pi mu d U f, F_d = eps F_t.
inline double coefficient_from_superficial_total(double f, const GasProperties& gas, double eps,
                                                 double diameter) {
  return stokes_coefficient(gas, diameter) * eps * eps * f;
}

}  // namespace gasgrain
