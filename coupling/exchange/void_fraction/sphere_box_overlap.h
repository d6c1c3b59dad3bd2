// The volume that the unit sphere about the origin shares with axis-aligned boxes, in closed form.
//
// Let the signed corner volume F(a, b, c) be that of the sphere within the box from the origin to
// (a, b, c), odd in each argument. A box has the alternating sum of F over its eight corners. For
// positive arguments
//
//   F = a b c                                                      when a^2 + b^2 + c^2 <= 1,
//   F = pi/6 - Q(a) - Q(b) - Q(c) + W(a, b) + W(b, c) + W(c, a)    otherwise:
//
// of the octant, what is beyond each plane, less what that counts twice; nothing is beyond all
// three. With d = sqrt(1 - a^2 - b^2)
//
//   Q(a) = pi/12 (1 - a)^2 (2 + a)                       in the octant, beyond x = a
//   W(a, b) = (2 atan(d / ab) - a (3 - a^2) atan(d / b)
//              - b (3 - b^2) atan(d / a) + 2 a b d) / 6  in the octant, beyond x = a and y = b
//
// Source: W by the divergence theorem, the spherical part of the surface by that of Gauss and
//   Bonnet. S. Strobl, A. Formella, T. Poeschel, J. Comput. Phys. 311 (2016) 158 has the general
//   case, of which this is the one of right angles.
// Inputs: coordinates in radii of the sphere. Output: volumes in cubed radii.
// Accuracy: every term is of order 1 and no divisor is small, so that the error is some 1e-16 of
//   the sphere's volume however the box lies; the RELATIVE error of a sliver may be of any size.
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/base/vec3.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {

// A plane across an axis, -1 <= at <= 1, with what all its corners need.
struct SphereCut {
  double at = 0.0;
  double square = 0.0;
  double quarter_cap = 0.0;  // Q(|at|)
};

inline SphereCut sphere_cut(double at) {
  const double a = std::abs(at);
  return {at, a * a, pi / 12.0 * (1.0 - a) * (1.0 - a) * (2.0 + a)};
}

// W(|x|, |y|).
inline double half_wedge(const SphereCut& x, const SphereCut& y) {
  const double a = std::abs(x.at);
  const double b = std::abs(y.at);
  const double d_square = (1.0 - a) * (1.0 + a) - y.square;
  if (d_square <= 0.0) return 0.0;
  const double d = std::sqrt(d_square);
  return (2.0 * std::atan2(d, a * b) - a * (3.0 - x.square) * std::atan2(d, b) -
          b * (3.0 - y.square) * std::atan2(d, a) + 2.0 * a * b * d) /
         6.0;
}

// F, given the sum of the three half wedges.
inline double corner_volume(const SphereCut& x, const SphereCut& y, const SphereCut& z,
                            double wedges) {
  const double product = x.at * y.at * z.at;
  if (x.square + y.square + z.square <= 1.0) return product;
  const double size = pi / 6.0 - x.quarter_cap - y.quarter_cap - z.quarter_cap + wedges;
  return std::copysign(size, product);
}

// A single box lo <= hi; it may reach beyond the sphere.
inline double sphere_box_overlap(const Vec3& lo, const Vec3& hi) {
  SphereCut cut[3][2];
  for (int d = 0; d < 3; ++d) {
    cut[d][0] = sphere_cut(std::clamp(lo[d], -1.0, 1.0));
    cut[d][1] = sphere_cut(std::clamp(hi[d], -1.0, 1.0));
  }
  double volume = 0.0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        const SphereCut& x = cut[0][i];
        const SphereCut& y = cut[1][j];
        const SphereCut& z = cut[2][k];
        const double corner =
            corner_volume(x, y, z, half_wedge(x, y) + half_wedge(y, z) + half_wedge(z, x));
        volume += (i + j + k) % 2 == 1 ? corner : -corner;
      }
  return std::max(0.0, volume);
}

}  // namespace gasgrain
