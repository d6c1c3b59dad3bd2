// JKR contact: elastic spheres that adhere over the whole of their contact.
//
//   F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3),   delta = a^2 / R* - sqrt(2 pi w a / E*)
//
// a is the contact's radius. Pulled apart, the contact keeps a neck below zero overlap. Under a
// prescribed overlap, as DEM has it, the neck snaps at
//   a_s = (pi w R*^2 / (8 E*))^(1/3),   delta_s = -3 a_s^2 / R*,   F = -5/6 pi w R*
// and before that, at a = 9^(1/3) a_s, the pull is greatest: 3/2 pi w R*. Approaching bodies feel
// nothing before they touch; at delta = 0 the pull is 4/3 pi w R* at once. That jump and the neck
// are the law's own dissipation: a cycle of touch and snap takes 7.09 (w^5 R*^4 / E*^2)^(1/3).
//
// With a = a_s q^2 the second equation is q^4 - 4 q = delta R* / a_s^2, q >= 1, which Ferrari's
// method solves in closed form: with d the right-hand side,
//   m^3 + d m - 2 = 0,   q = (sqrt(2 m) + sqrt(4 sqrt(2/m) - 2 m)) / 2
//
// Source: K.L. Johnson, K. Kendall, A.D. Roberts, Proc. R. Soc. A 324 (1971) 301. The work of a
//   cycle: C. Thornton, Z. Ning, Powder Technol. 99 (1998) 154. w of surface energies: A. Dupre;
//   unlike ones: L.A. Girifalco, R.J. Good, J. Phys. Chem. 61 (1957) 904.
// Inputs: E* [Pa], R* [m], w [J/m^2], overlap delta [m] (below 0: a gap). Output: repulsion [N],
//   below 0 when the bodies are drawn together; it holds Hertz's force. attraction(): what JKR adds
//   to Hertz's force [N], for a cohesion model beside a `hertz` normal model.
// Assumptions: smooth, elastic; a much below R*; Tabor's number above 5 (below 0.1 the pull-off
//   force is DMT's, 2 pi w R*). A DEM stiffness that is softened makes the neck longer by its -2/3
//   power; the pull-off force does not depend on it.
// Range: any overlap with a below R* / 2 or so. w = 0 is Hertz's force bit for bit.
// Deviations: none. Alobaid (2013) has no JKR.
#pragma once

#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::adhesion {

// w [J/m^2] of the surface energies of both bodies and of their interface.
inline double work_of_adhesion(double surface_i, double surface_j, double interface) {
  return surface_i + surface_j - interface;
}
// w where the interface is not known; of one material with itself 2 gamma.
inline double work_of_adhesion(double surface_i, double surface_j) {
  return 2.0 * std::sqrt(surface_i * surface_j);
}

struct Jkr {
  double modulus = 0.0;         // E* [Pa]
  double reduced_radius = 0.0;  // R* [m]
  double work = 0.0;            // w [J/m^2]

  double pull_off_force() const { return 1.5 * contact::pi * work * reduced_radius; }
  double snap_radius() const {
    return std::cbrt(contact::pi * work * reduced_radius * reduced_radius / (8.0 * modulus));
  }
  double snap_overlap() const {
    const double a = snap_radius();
    return -3.0 * a * a / reduced_radius;
  }
  // Whether the bodies hold on to each other: `touched` says whether they did before.
  bool touches(double overlap, bool touched) const {
    return overlap > 0.0 || (touched && work > 0.0 && overlap >= snap_overlap());
  }

  // Radius of the contact [m] while the bodies touch.
  double contact_radius(double overlap) const {
    if (work == 0.0) return std::sqrt(reduced_radius * std::fmax(overlap, 0.0));
    const double a = snap_radius();
    const double q = root(overlap * reduced_radius / (a * a));
    return a * q * q;
  }
  // The whole normal force while the bodies touch.
  double repulsion(double overlap) const {
    if (work == 0.0) return hertz(overlap);
    const double a = snap_radius();
    const double q = root(overlap * reduced_radius / (a * a));
    const double q3 = q * q * q;
    return pull_off_force() * q3 * (q3 - 6.0) / 9.0;
  }
  double hertz(double overlap) const {
    if (!(overlap > 0.0)) return 0.0;
    return contact::hertz_stiffness(modulus, reduced_radius) * overlap * std::sqrt(overlap);
  }
  // What the surfaces add to Hertz's force while the bodies touch.
  double attraction(double overlap) const { return hertz(overlap) - repulsion(overlap); }

  // Work [J] of one cycle: the jump at touch and the neck's way to the snap.
  double work_of_cycle() const {
    const double a = snap_radius();
    const double touch = std::cbrt(4.0);  // q at delta = 0
    const auto integral = [](double q) {
      const double q3 = q * q * q;
      return 4.0 / 9.0 * q * q3 * (0.1 * q3 * q3 - q3 + 1.5);
    };
    return (integral(1.0) - integral(touch)) * pull_off_force() * a * a / reduced_radius;
  }
  // mu: how far the neck stretches in units of z0, the reach of the surfaces' attraction [m].
  double tabor_number(double reach) const {
    const double ratio = work / (modulus * reach);
    return std::cbrt(reduced_radius * ratio * ratio / reach);
  }

 private:
  // q >= 1 of q^4 - 4 q = d; below the snap, d < -3, that of the snap.
  static double root(double d) {
    if (d <= -3.0) return 1.0;
    const double third = d / 3.0;
    const double a = std::cbrt(1.0 + std::sqrt(1.0 + third * third * third));
    const double b = -third / a;
    // a + b; for d > 0 the two nearly cancel, and (a^3 + b^3) / (a^2 - a b + b^2) does not
    const double m = d > 0.0 ? 2.0 / (a * a + third + b * b) : a + b;
    return 0.5 *
           (std::sqrt(2.0 * m) + std::sqrt(std::fmax(4.0 * std::sqrt(2.0 / m) - 2.0 * m, 0.0)));
  }
};

inline void check(const Jkr& law) {
  InputFaults("A JKR contact")
      .positive("effective modulus", law.modulus, "Pa", "of two like bodies it is E/2/(1 - nu^2)")
      .positive("reduced radius", law.reduced_radius, "m", "R1 R2 / (R1 + R2); R at a wall")
      .not_negative("work of adhesion", law.work, "J/m2",
                    "most surfaces have 0.01 to 1 J/m2; give 0 to switch it off")
      .refuse();
}

}  // namespace gasgrain::adhesion
