// What a mixture of sizes makes of a drag law for spheres of one size.
//
//   y = d / d_s,  1 / d_s = sum of x / d (d_s Sauter's mean diameter, x the share of solid volume)
//   total force:      F_t(d) = (eps y + phi y^2 + 0.064 eps y^3) F_t,  phi = 1 - eps
//   drag of model A:  F_d(d) = y F_d
// each in units of Stokes' drag of its own diameter, the right sides being those of a bed of
// spheres of d_s: the same eps and slip, Re of d_s. Hence K(d) = y^2 K(d_s).
//
// Source: M.A. van der Hoef, R. Beetstra, J.A.M. Kuipers, J. Fluid Mech. 528 (2005) 233; for all Re
//   R. Beetstra, M.A. van der Hoef, J.A.M. Kuipers, AIChE J. 53 (2007) 489 and its erratum.
// Inputs: y [-] not negative, eps [-]; K as in models.h. Output: factors [-]; K [kg/s].
// Assumptions: all sizes have the same slip. Of the total force the part phi y^2 F_t is that of the
//   pressure gradient; with F_d = eps F_t the first term leaves y to the drag of model A.
// Range: ratios of diameters up to 4, Re up to 1000.
// Deviations: the third term, a fit, is left out of the drag of model A. It does not vanish for one
//   size (up to 6.4 % too much), nor leave the pressure drop that of the bed of d_s. Without it
//   spheres of y = 2 feel up to a fifth less drag, those of y = 4 up to a half.
#pragma once

#include "coupling/exchange/drag/basis.h"

namespace gasgrain {

inline double polydisperse_total_factor(double y, double eps) {
  return eps * y + (1.0 - eps) * y * y + 0.064 * eps * y * y * y;
}

inline double polydisperse_drag_factor(double y) {
  return y;
}

// K of a sphere in a mixture [kg/s].
template <class Law>
double polydisperse_coefficient(const GasProperties& gas, double eps, double slip_speed,
                                double diameter, double sauter_diameter) {
  const double y = diameter / sauter_diameter;
  return polydisperse_drag_factor(y) * y * Law::coefficient(gas, eps, slip_speed, sauter_diameter);
}

}  // namespace gasgrain
