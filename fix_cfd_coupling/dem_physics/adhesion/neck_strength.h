// What a sintered neck bears, and when it breaks.
//
//   pull held by a neck of gap s    F = k s, at most sigma A;   A = n pi x^2
//   broken when                     F_n >= sigma A   or   |F_t| >= tau A
//
// The neck is as stiff as the contact that it joins: where the grains' contact ends, at zero
// overlap, the force passes through zero and goes on as a pull, without a jump. A broken neck is
// gone: its radius x is set to 0. While the neck holds the grains do not slide on each other.
//
// Source: K. Kuwagi, T. Mikami, M. Horio, Powder Technol. 109 (2000) 27; Alobaid (2013), eqs 5.93
//   to 5.97.
// Inputs: A [m^2] of Sintering::area(), sigma, tau tensile and shear strength [Pa], k [N/m], gap s
//   [m], forces [N]; F_n above 0 for a pull. Output: attraction [N], 0 or above.
// Assumptions: n equal necks (n = 1, 3, 9) that share the load.
// Range: s >= 0; an overlap is the contact's own force, and the neck adds nothing.
// Deviations: sigma_nec of eqs 5.93 to 5.96, called a surface energy, is a stress by its unit, the
//   tensile strength; t_nec of eq 5.97 is the shear strength tau. Eq 5.97 takes the size of the
//   normal force; here only a pull breaks the neck, as a grain pressed on does not come off. x in
//   the force is that of one neck, and n counts them once.
#pragma once

#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"

namespace gasgrain::adhesion {

struct NeckStrength {
  double tensile = 0.0;  // sigma [Pa]
  double shear = 0.0;    // tau [Pa]

  double greatest_pull(double area) const { return tensile * area; }
  double greatest_shear(double area) const { return shear * area; }
  // A neck of no area holds nothing.
  bool holds(double pull, double tangential, double area) const {
    return pull < greatest_pull(area) && std::abs(tangential) < greatest_shear(area);
  }
};

// The pull of a neck stretched by the gap.
inline double neck_attraction(double stiffness, double gap) {
  return stiffness * std::max(gap, 0.0);
}
// The gap [m] at which a neck that is pulled straight breaks.
inline double breaking_gap(const NeckStrength& strength, double area, double stiffness) {
  return strength.greatest_pull(area) / stiffness;
}

inline void check(const NeckStrength& law) {
  constexpr auto remedy = "give it in Pa; hot metals bear some 1e7";
  InputFaults("The strength of sintered necks")
      .not_negative("tensile strength", law.tensile, "Pa", remedy)
      .not_negative("shear strength", law.shear, "Pa", remedy)
      .require((law.tensile > 0.0) == (law.shear > 0.0), "shear strength", law.shear, "Pa",
               "above 0 as the tensile strength is", "give both, or neither")
      .refuse();
}

}  // namespace gasgrain::adhesion
