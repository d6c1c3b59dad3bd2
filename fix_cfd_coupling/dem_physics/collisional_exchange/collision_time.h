// Time between the collisions of a particle, (13)-(19) of O'Rourke, Zhao and Snider, Chem. Eng.
// Sci. 64 (2009) 1784.
//
//   1 / tau_coll = u'_rms / r_32  theta_cp theta_p / (theta_cp - theta_p)      (13)
//   theta_cp = min(theta_cp,s theta_p / theta_s, 1)                            (17)
//
// Its binary collision frequency (21) has a factor 3 2^(1/2) that (13) has not. The paper's figures
// agree with (13) as printed: 1.5 m/s, 50 um and 0.2 with 0.58 give 1.1e-4 s, its text states about
// 2e-4 s; with the factor it were 2.6e-5 s.
// u'_rms [m/s], r_32 [m], 1/tau [1/s], fractions of the cell's volume.
#pragma once

#include <algorithm>
#include <limits>

namespace gasgrain {

// theta_cp of (17) from theta_cp,s, theta_p and theta_s <= theta_p.
inline double close_packing_of_wet(double of_solids, double particles, double solids) {
  return solids > 0.0 ? std::min(of_solids * particles / solids, 1.0) : 1.0;
}

// 1/tau [1/s]: 0 when all velocities are equal, infinite at close packing and beyond otherwise.
inline double collision_frequency(double rms_velocity, double sauter_radius, double particles,
                                  double close_packing) {
  if (!(rms_velocity > 0.0) || !(sauter_radius > 0.0)) return 0.0;
  if (particles >= close_packing) return std::numeric_limits<double>::infinity();
  return rms_velocity / sauter_radius * close_packing * particles / (close_packing - particles);
}

}  // namespace gasgrain
