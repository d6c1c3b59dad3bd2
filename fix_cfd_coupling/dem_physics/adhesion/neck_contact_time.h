// The time for which a neck grows in a collision whose stiffness is not the real one.
//
//   t_growth = T_real / T_dem min(t, T_dem) + max(0, t - T_dem)
//
// t is how long the grains have touched in the simulation, T_dem the duration of a free collision
// with its (softened, often linear) contact, T_real that with the real one (Hertz). A collision
// that lasts T_dem gives T_real of growth, hence the neck of the real collision; what touches for
// longer than a collision rests, and its time is real.
//
// Source: K. Kuwagi, T. Mikami, M. Horio, Powder Technol. 109 (2000) 27; Alobaid (2013), eqs 5.98
//   to 5.103.
// Inputs: times [s]; durations of contact_time.h (hertz_duration(), linear_duration()), with the
//   speed at which the grains met. Output: growth time [s], for Sintering::grown().
// Assumptions: T_real and T_dem of the same pair and speed; the neck itself does not lengthen them.
// Range: t >= 0, T > 0. T_real = T_dem is t itself.
// Deviations:
//   - Eq 5.101 has 2.44 (m^2 / (xi^2 u))^(1/5). With xi of eq 5.103, Hertz's stiffness of equal
//     spheres, and the reduced mass, Hertz's theory gives 3.218; 2.44 is right with the mass of one
//     of the two equal grains. hertz_duration() has it right for any pair.
//   - Eq 5.99 adds the corrected time to the time before it, by the text a softened one; here it
//     takes its place, as else a collision counts twice.
//   - Eqs 5.99 and 5.100 scale every time. A grain that rests on another for a second does sinter
//     for a second: only the first T_dem of a contact are scaled.
//   - Eq 5.98 starts from a neck and cannot begin one; Sintering::grown() can.
#pragma once

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"

namespace gasgrain::adhesion {

struct CollisionDurations {
  double in_dem;  // T_dem [s]
  double real;    // T_real [s]

  double growth_time(double contact_time) const {
    // what is short of T_dem, and what is beyond; together the contact's time
    const double collision = std::min(contact_time, in_dem);
    return collision * (real / in_dem) + (contact_time - collision);
  }
  // Growth during a step of the contact from `before` to `after` [s].
  double growth_between(double before, double after) const {
    return growth_time(after) - growth_time(before);
  }
};

inline void check(const CollisionDurations& of) {
  InputFaults("The correction of a neck's contact time")
      .positive("duration in the simulation", of.in_dem, "s",
                "take it from contact_time.h with a speed above 0")
      .positive("real duration", of.real, "s", "take it from contact_time.h with a speed above 0")
      .refuse();
}

}  // namespace gasgrain::adhesion
