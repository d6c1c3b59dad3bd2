// A plane of spheres of equal diameter D, simulated on a grid one cell deep, taken for a slice of a
// bed in space. Void fractions of a plane are lower bounds that no drag law was fitted to; the
// slice has those of space:
//
//   depth of the cells            h_y = 2 * 3^(-3/4) D                          (eq. 35)
//   void fraction                 1 - eps_3D = 2 / sqrt(pi sqrt 3) (1 - eps_2D)^(3/2)   (eq. 33)
//
// eps_2D being that of the discs in the plane. The closest packing of the plane, 0.907, becomes
// that of space, 0.740. Source: B.P.B. Hoomans et al., Powder Technol. 116 (2001) 166. Both were
// derived again: eq. 33 from a hexagonal lattice and a face-centred cubic cell of equal distances
// between centres, whose phi_3D / phi_2D^(3/2) is the same at every distance; eq. 35 as the depth
// at which the spheres' own volume is that of eq. 33 when each has a square of D x D (phi_2D = pi /
// 4). Assumptions: one layer of spheres of one diameter. The solids of a cell are those of the
// slice, not the sum of its spheres' volumes: that is 0.93 of them at the closest packing and more
// below 0.785.
#pragma once

#include <cmath>

namespace gasgrain {

// h_y / D
inline const double plane_depth_in_diameters = 2.0 * std::pow(3.0, -0.75);

// Volume fraction of solids from that of the spheres in cells of depth h_y. The spheres' volume
// divided by D is 2/3 of their discs' area.
inline double solids_in_space(double fraction_in_cell) {
  const double discs = 1.5 * fraction_in_cell * plane_depth_in_diameters;
  return 2.0 / std::sqrt(M_PI * std::sqrt(3.0)) * std::pow(discs, 1.5);
}

}  // namespace gasgrain
