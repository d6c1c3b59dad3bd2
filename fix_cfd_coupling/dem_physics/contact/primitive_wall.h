// A wall that a formula describes: a plane across an axis, or a round cylinder along one.
//
//   plane      d = x - C along the axis
//   cylinder   d points from the nearest point of the shell to the centre of the grain; grains may
//              be inside of it (pushed towards the axis) or outside
//
// Units: m. A grain on the cylinder's axis has no nearest point: it is infinitely far.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "fix_cfd_coupling/dem_physics/contact/triple.h"

namespace gasgrain::contact {

struct PrimitiveWall {
  int axis = 0;  // across a plane, along a cylinder
  bool round = false;
  double place = 0.0;                // C, of a plane
  double radius = 0.0;               // of a cylinder,
  std::array<double, 2> centre{};    // in the two axes that follow its own
  std::array<double, 3> velocity{};  // [m/s] of its surface

  // d [m]; its length is returned.
  [[gnu::always_inline]] inline double reach(const double* x, Triple& to_grain) const {
    double* d = to_grain.data();
    d[0] = d[1] = d[2] = 0.0;
    if (!round) {
      d[axis] = x[axis] - place;
      return std::abs(d[axis]);
    }
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double from_a = x[a] - centre[0], from_b = x[b] - centre[1];
    const double off_axis = std::sqrt(from_a * from_a + from_b * from_b);
    if (off_axis == 0.0) return std::numeric_limits<double>::infinity();
    const double share = (off_axis - radius) / off_axis;  // below 0 inside
    d[a] = from_a * share;
    d[b] = from_b * share;
    return std::abs(off_axis - radius);
  }

  // R* [m] of a grain of radius R in or on a cylinder of radius C along its curved way, as LAMMPS's
  // own granular walls take it: 2 R C / (2 C - R) inside, 2 R C / (2 C + R) outside.
  [[nodiscard]] [[gnu::always_inline]] inline double reduced_radius(const double* x,
                                                                    double of_grain) const {
    const double from_a = x[(axis + 1) % 3] - centre[0], from_b = x[(axis + 2) % 3] - centre[1];
    const bool inside = from_a * from_a + from_b * from_b < radius * radius;
    const double of_wall = inside ? -2.0 * radius : 2.0 * radius;
    return of_grain * of_wall / (of_wall + of_grain);
  }
};

}  // namespace gasgrain::contact
