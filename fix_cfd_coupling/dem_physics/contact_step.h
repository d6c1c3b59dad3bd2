// How long a DEM step may be, as shares of the duration of a contact (contact_time.h) of the two
// smallest grains.
//
// stable_share, 1 / pi: velocity Verlet (leapfrog) is stable up to omega dt = 2. A pair oscillates
// with omega = pi / t_c; the stiffest motion of a close packing, 12 contacts a grain, with twice
// that: omega^2 = 8 k / M of face-centred spheres of mass M against 2 k / M of the pair. Hence
// dt = t_c / pi. Beyond it a packed bed feeds itself with energy: 1536 glass spheres dropped into a
// box came to rest with a kinetic energy of 1e-11 J at 0.1 t_c, 1e-9 at 0.2, 1e-8 at 0.3; at 0.4
// they kept 1e-8 (hertz) to 1e-6 J (hooke) and sank through each other, at 0.5 they were gone.
// Torques and tangential springs, which are softer, are left out.
//
// resolved_share, 1 / 10: the restitution of one contact depends on where in the step it begins.
// Asked for 0.97 a step of t_c / 20 gives 0.970 +- 0.001 (hertz; hooke +- 0.003), t_c / 10
// 0.967 to 0.974 (0.978), t_c / 5 0.954 to 0.987 (0.996).
#pragma once

#include <cmath>

namespace gasgrain::contact {

inline constexpr double stable_share = 0.318;  // beyond it a step is refused
inline constexpr double resolved_share = 0.1;  // beyond it a step is warned of
inline constexpr double advised_share = 0.05;

// Rounded down to two digits: what one writes into a script.
inline double two_digits_below(double value) {
  constexpr double round_off = 1e-9;
  const double number = value * (1.0 + round_off);
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::floor(number / unit) * unit;
}

}  // namespace gasgrain::contact
