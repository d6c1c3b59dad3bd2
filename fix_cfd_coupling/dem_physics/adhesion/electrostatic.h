// Electrostatic forces of grains that carry charges: on each other, and to a wall.
//
//   two charges     F = -q1 q2 / (4 pi eps0 eps_r (R1 + R2 + s)^2)
//   image at a wall F = q^2 / (16 pi eps0 eps_r (R + s)^2) (eps_w - eps_r) / (eps_w + eps_r)
//   charged wall    F = -q phi_w / (2 eps0 eps_r)
//   breakdown       q_b = 4 pi eps0 eps_r R^2 E_b
//
// phi [C/m^2] is a charge per area, q = 4 pi R^2 phi of a sphere. A wall that conducts has eps_w =
// infinity: the full image. q_b is the charge at which the field at a grain's surface reaches E_b,
// 3e6 V/m in air at 1 atm: the gas then conducts, and no grain keeps more.
//
// Source: laws of Coulomb and Gauss; the image: J.D. Jackson, Classical Electrodynamics, ch. 2, 4;
//   Alobaid (2013), eqs 5.61, 5.62, 5.64.
// Inputs: q [C] with sign, radii and gap [m], phi_w [C/m^2]. Output: attraction [N], above 0 when
//   the bodies are drawn together (unlike charges, any image), the same size for both.
// Assumptions: charges at the centres, evenly spread over insulating grains; grains do not polarise
//   each other; the wall is flat and grounded. An overlap is a gap below 0, down to -R.
// Range: gaps above -R; |q| up to q_b (a greater one is for the caller to count: over_breakdown()).
//   Grains far below 1 mm bear fields above E_b (Paschen).
// Deviations: eq 5.62 is Coulomb's law with q = 4 pi R^2 phi if its r_ij is the reduced diameter 2
//   R1 R2 / (R1 + R2), four times too small with that of eq 5.54. Eq 5.61's sign is that of a
//   repulsion, and eq 5.64 has no charge of the image, which is added here. The size of q_b is also
//   that of the estimate in coupling/exchange/effect_sizes/electrostatics.h.
#pragma once

#include <cmath>
#include <limits>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::adhesion {

inline constexpr double vacuum_permittivity = 8.8541878128e-12;  // eps0 [F/m]
inline constexpr double conductor = std::numeric_limits<double>::infinity();

struct Electrostatic {
  double medium_permittivity = 1.0;      // eps_r
  double wall_permittivity = conductor;  // eps_w
  double wall_charge = 0.0;              // phi_w [C/m^2]
  double breakdown_field = 3e6;          // E_b [V/m]

  double permittivity() const { return vacuum_permittivity * medium_permittivity; }

  double between_spheres(double q1, double q2, double r1, double r2, double gap) const {
    const double distance = r1 + r2 + gap;
    return -q1 * q2 / (4.0 * contact::pi * permittivity() * distance * distance);
  }
  // The share of the charge that its image has, of the opposite sign.
  double image_share() const {
    if (std::isinf(wall_permittivity)) return 1.0;
    return (wall_permittivity - medium_permittivity) / (wall_permittivity + medium_permittivity);
  }
  // The image and the wall's own charge.
  double to_wall(double q, double r, double gap) const {
    const double distance = r + gap;
    const double image =
        image_share() * q * q / (16.0 * contact::pi * permittivity() * distance * distance);
    return image - 0.5 * q * wall_charge / permittivity();
  }
  double breakdown_charge(double r) const {
    return 4.0 * contact::pi * permittivity() * r * r * breakdown_field;
  }
  bool over_breakdown(double q, double r) const { return std::abs(q) > breakdown_charge(r); }
};

inline double charge_of_sphere(double charge_per_area, double r) {
  return 4.0 * contact::pi * r * r * charge_per_area;
}

inline void check(const Electrostatic& law) {
  InputFaults faults("The electrostatic force");
  faults.at_least("permittivity of the medium", law.medium_permittivity, 1.0, "",
                  "give the relative one, 1 for gas");
  faults.require(law.wall_permittivity >= 1.0, "permittivity of the wall", law.wall_permittivity,
                 "", "1 or above",
                 "give the relative one, infinity for a conductor, 1 for no image");
  faults.finite("charge of the wall", law.wall_charge, "C/m2", "give 0 for a wall without charge");
  faults.positive("breakdown field", law.breakdown_field, "V/m", "air at 1 atm has 3e6 V/m");
  if (law.breakdown_field > 0.0)
    faults.require(std::abs(law.wall_charge) <= law.permittivity() * law.breakdown_field,
                   "charge of the wall", law.wall_charge, "C/m2",
                   fmt::format("at most {:.3g} in size, where the gas breaks down",
                               law.permittivity() * law.breakdown_field),
                   "give it in C/m2, not in uC/m2");
  faults.refuse();
}

}  // namespace gasgrain::adhesion
