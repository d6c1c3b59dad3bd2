// How fast two touching spheres roll on each other.
//
//   w = w_i - w_j without its part along n,   v = R* |w|,   R* = R_i R_j / (R_i + R_j)
//
// R* of a wall is R_i. n is the unit vector of the centre line; its sense does not matter. v is how
// fast the contact moves over the two surfaces relative to the mean of their motion, the same for
// every observer, who may turn. w_j = 0 of a wall at rest.
//
// Source: M.R. Kuhn, K. Bagi, Int. J. Solids Struct. 41 (2004) 5793.
// Inputs: w_i, w_j [rad/s], n. Output: w [rad/s], across n.
// Deviations: eqs 5.111 and 5.112 of Alobaid (2013) take (r_i w_i + r_k w_k) x n, which is by how
//   much spins make the surfaces slide: it is 0 of two equal grains that roll on each other like
//   gears, and greatest of two that turn as one body and do not roll at all.
#pragma once

#include "coupling/base/vec3.h"

namespace gasgrain::rolling {

inline Vec3 relative_rolling(const Vec3& spin_i, const Vec3& spin_j, const Vec3& normal) {
  const Vec3 relative = spin_i - spin_j;
  return relative - relative.dot(normal) * normal;
}

}  // namespace gasgrain::rolling
