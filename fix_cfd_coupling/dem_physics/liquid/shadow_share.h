// The part of a grain's film that flows into a bridge: that in the shadow of its neighbour.
//
//   a = (1 - (1 - (r_j / (r_i + r_j))^2)^(1/2)) / 2 of the surface of i;   1/2 at a wall
//
// Source: Shi and McCarthy, Powder Technol. 184 (2008) 64: the cap under the cone that touches the
//   neighbour. Equal grains give 0.067 of their films.
// Assumes: the film is even. Shadows of grains that touch one grain and do not overlap each other
//   are apart, so that the shares of all neighbours never pass 1 (0.80 for twelve equal ones).
#pragma once

#include <cmath>

namespace gasgrain::liquid {

inline double shadow_share(double radius_i, double radius_j) {
  const double sine = radius_j / (radius_i + radius_j);
  // (1 - root) / 2 without the loss of digits of a small neighbour
  return 0.5 * sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
}

inline constexpr double shadow_share_of_wall = 0.5;

}  // namespace gasgrain::liquid
