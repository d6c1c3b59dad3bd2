// Two spheres that touch, or a sphere and a wall: where, how deep, and how they move there.
//
//   n = (x_i - x_j) / r          delta = R_i + R_j - r           r = |x_i - x_j|
//   v_n = (v_i - v_j) . n        above 0 where they part
//   v_t = v_i - v_j - v_n n - (l_i w_i + l_j w_j) x n            slip of the surfaces
//   R* = R_i R_j / (R_i + R_j)   m* = m_i m_j / (m_i + m_j)
//
// The lever arms l go to the middle of the overlap, R - delta / 2, or are the radii: a tangential
// law says which. A wall has R_j = 0, no spin of its own, R* = R_i and m* = m_i; r is the distance
// of the centre from its nearest point.
//
// A normal law writes k_n, k_t, gamma_n, gamma_t and F_n; the tangential and rolling laws read
// them. Units: SI, spins [rad/s]. Assumes spheres.
#pragma once

#include <cmath>
#include <cstddef>

#include "fix_cfd_coupling/dem_physics/contact/triple.h"

namespace gasgrain::contact {

// Real is a double, or one of each of several contacts of one pair of types (lanes.h).
template <class Real>
struct TouchOf {
  TripleOf<Real> normal;  // from j, or the wall, to i
  Real distance = 0.0, overlap = 0.0;
  Real radius_i = 0.0, radius_j = 0.0, reduced_radius = 0.0;
  Real mass_i = 0.0, mass_j = 0.0, reduced_mass = 0.0;
  Real lever_i = 0.0, lever_j = 0.0;
  TripleOf<Real> spin_i, spin_j;
  Real parting = 0.0;     // v_n
  TripleOf<Real> slip;    // v_t
  std::size_t types = 0;  // the place of the pair of types in a PairTable
  bool is_wall = false;
  bool updates = false;  // the history may change
  double step = 0.0;     // [s]

  // of the normal law
  Real prepared = 0.0;                                      // by its prepare(), where it has one
  Real normal_stiffness = 0.0, tangential_stiffness = 0.0;  // [N/m]
  Real normal_damping = 0.0, tangential_damping = 0.0;      // [N s/m]
  Real normal_force = 0.0;                                  // on i along n, damping included
};
using Touch = TouchOf<double>;

// Fills what follows from distance, radii, masses, spins and the velocity of i relative to j.
template <bool levers_are_radii, class Real>
[[gnu::always_inline]] inline void find_motion(TouchOf<Real>& touch,
                                               const TripleOf<Real>& velocity) {
  const Real half = levers_are_radii ? Real(0.0) : 0.5 * touch.overlap;
  touch.lever_i = touch.radius_i - half;
  touch.lever_j = touch.is_wall ? Real(0.0) : touch.radius_j - half;
  touch.parting = velocity.dot(touch.normal);
  TripleOf<Real> turning = touch.lever_i * touch.spin_i;
  if (!touch.is_wall) turning += touch.lever_j * touch.spin_j;
  touch.slip = velocity - touch.parting * touch.normal - cross(turning, touch.normal);
}

}  // namespace gasgrain::contact
