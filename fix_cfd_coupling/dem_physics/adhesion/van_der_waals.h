// Van der Waals' force between two spheres and between a sphere and a wall.
//
//   spheres   F = 32/3 A (R1 R2)^3 (s + R1 + R2) / [s (s + 2 R1 + 2 R2) (s + 2 R1) (s + 2 R2)]^2
//   wall      F = 2/3 A R^3 / [s (s + 2 R)]^2
//   near      F = A R* / (6 s^2),   R* = R1 R2 / (R1 + R2); of a wall R* = R   (Derjaguin)
//
// The first is dE/dr of Hamaker's energy of two spheres, with its three terms, which cancel each
// other, brought to one. Far away E goes with r^-6 and F with r^-7.
// The gap is not taken below `smallest_gap` z0: touching and overlapping bodies are at z0 (some
// 0.165 to 0.4 nm), where F is greatest. Beyond `greatest_gap` F is 0; what is cut off there is
// about (z0 / greatest_gap)^2 of the greatest force, and gap_of_share() gives the gap of a share.
//
// Source: H.C. Hamaker, Physica 4 (1937) 1058; Alobaid (2013), eqs 5.50 to 5.56.
// Inputs: A [J] (hamaker_constant.h), radii and gap [m], gap < 0 for an overlap. Output: attraction
//   [N], above 0 when the bodies are drawn together; the same for both, along their centre line.
// Assumptions: smooth spheres, not retarded. Rough ones: the asperity's radius in place of R in the
//   near form, which is too high by a share of s/R* to first order.
// Range: any gap; R > z0. A < 0 repels.
// Deviations: eqs 5.53 and 5.54 interchange the names of gap and reduced radius. The first form of
//   eq 5.56 has 12 where its second form, the limit of eq 5.54 and Hamaker have 6.
#pragma once

#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::adhesion {

// Derjaguin's near form for a reduced radius R*; s > 0.
inline double hamaker_near(double hamaker, double reduced_radius, double s) {
  return hamaker * reduced_radius / (6.0 * s * s);
}

// The full forms; s > 0. Written in ratios, so that no power of a small radius is lost.
inline double hamaker_spheres(double hamaker, double r1, double r2, double s) {
  const double reduced = contact::effective(r1, r2);
  const double sum = r1 + r2;
  const double far = (1.0 + 0.5 * s / sum) * (1.0 + 0.5 * s / r1) * (1.0 + 0.5 * s / r2);
  return hamaker_near(hamaker, reduced, s) * (1.0 + s / sum) / (far * far);
}
inline double hamaker_wall(double hamaker, double r, double s) {
  const double far = 1.0 + 0.5 * s / r;
  return hamaker_near(hamaker, r, s) / (far * far);
}

struct VanDerWaals {
  double hamaker = 0.0;         // A [J]
  double smallest_gap = 4e-10;  // z0 [m]
  double greatest_gap = 1e-6;   // [m]

  double between_spheres(double r1, double r2, double gap) const {
    if (gap > greatest_gap) return 0.0;
    return hamaker_spheres(hamaker, r1, r2, std::max(gap, smallest_gap));
  }
  double to_wall(double r, double gap) const {
    if (gap > greatest_gap) return 0.0;
    return hamaker_wall(hamaker, r, std::max(gap, smallest_gap));
  }
  // The gap [m] at which the near form has fallen to this share of the greatest force.
  double gap_of_share(double share) const { return smallest_gap / std::sqrt(share); }
};

inline void check(const VanDerWaals& law) {
  InputFaults("Van der Waals' force")
      .finite("Hamaker's constant", law.hamaker, "J", "most pairs in air have 1e-20 to 5e-19 J")
      .require(std::abs(law.hamaker) < 1e-17, "Hamaker's constant", law.hamaker, "J",
               "below 1e-17 in size", "give it in J, not in zJ or eV")
      .positive("smallest gap", law.smallest_gap, "m",
                "bodies in touch are 1.65e-10 to 4e-10 m off")
      .require(law.greatest_gap > law.smallest_gap, "greatest gap", law.greatest_gap, "m",
               fmt::format("above the smallest gap of {:g} m", law.smallest_gap),
               "a hundred smallest gaps leave off 1e-4 of the greatest force")
      .refuse();
}

}  // namespace gasgrain::adhesion
