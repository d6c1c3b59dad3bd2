// Electrostatic force of conducting bodies that differ by a contact potential.
//
//   F = pi eps0 eps_r U^2 R* / s,   R* = R1 R2 / (R1 + R2); of a wall R* = R
//
// It is Derjaguin's integral of the plate condenser's pressure eps0 eps_r U^2 / (2 s^2), the
// leading term of the sphere's exact force at small gaps.
//
// Source: Alobaid (2013), eqs 5.63, 5.65.
// Inputs: U [V], 0.01 to 1 V between metals, R* and gap [m]. Output: attraction [N], 0 or above.
// Assumptions: the potential stays (bodies in touch exchange charge); s much below R*.
// Range: gaps to R* / 100 within some 2 %; below `smallest_gap` (touching, overlapping) F is that
//   of the smallest gap; beyond `greatest_gap` 0.
// Deviations: eq 5.63 has pi/2, which is right if its r_ij is the reduced diameter, and half of eq
//   5.65's limit with the reduced radius of eq 5.54.
#pragma once

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/electrostatic.h"
#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::adhesion {

struct ContactPotential {
  double potential = 0.0;  // U [V]
  double medium_permittivity = 1.0;
  double smallest_gap = 4e-10;  // [m]
  double greatest_gap = 1e-6;   // [m]

  double attraction(double reduced_radius, double gap) const {
    if (gap > greatest_gap) return 0.0;
    return contact::pi * vacuum_permittivity * medium_permittivity * potential * potential *
           reduced_radius / std::max(gap, smallest_gap);
  }
};

inline void check(const ContactPotential& law) {
  InputFaults("The force of a contact potential")
      .finite("contact potential", law.potential, "V", "metals differ by 0.01 to 1 V")
      .at_least("permittivity of the medium", law.medium_permittivity, 1.0, "",
                "give the relative one, 1 for gas")
      .positive("smallest gap", law.smallest_gap, "m",
                "bodies in touch are 1.65e-10 to 4e-10 m off")
      .require(law.greatest_gap > law.smallest_gap, "greatest gap", law.greatest_gap, "m",
               fmt::format("above the smallest gap of {:g} m", law.smallest_gap),
               "the near form holds to a hundredth of the grain's radius")
      .refuse();
}

}  // namespace gasgrain::adhesion
