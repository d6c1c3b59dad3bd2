// Rebound of parcels from the sides of the box.
//
//   v_n -> -retention_normal v_n,   v_t -> retention_tangential v_t
//
// at the side; what is left of the step's path is run with the velocity after the rebound. A
// particle's centre comes no nearer to a wall than its radius (at most a quarter of a cell's size,
// so that large parcels still reach the cells along a wall).
// Source: the momentum retention coefficients that MP-PIC codes use, with the values 0.3 and 0.99
// of Alobaid (2013), table 10.4; diffuse bounce is not modelled (0 in that table).
// Sides that are not named are open: parcels pass them, and the host takes them out of the run.
#pragma once

#include <algorithm>
#include <array>

#include "coupling/base/box_grid.h"

namespace gasgrain {

struct Walls {
  std::array<std::array<bool, 2>, 3> side{};  // [axis][0: low, 1: high], true: a wall
  double retention_normal = 0.3;
  double retention_tangential = 0.99;
};

// Where a parcel is after the step, and its velocity; how often it met a wall.
struct FreeFlight {
  Vec3 position;
  Vec3 velocity;
  int rebounds = 0;
};

// Flight from x with velocity v over dt. radius: of a particle [m].
inline FreeFlight fly(const Vec3& x, const Vec3& v, double radius, double dt, const BoxGrid& grid,
                      const Walls& walls) {
  FreeFlight flight{x + dt * v, v, 0};
  const Vec3 h = grid.spacing();
  for (int d = 0; d < 3; ++d) {
    if (grid.periodic[d]) continue;
    const double gap = std::min(radius, 0.25 * h[d]);
    for (int high = 0; high < 2; ++high) {
      if (!walls.side[d][high]) continue;
      const double plane = high ? grid.hi[d] - gap : grid.lo[d] + gap;
      const double outward = high ? 1.0 : -1.0;
      if (outward * (flight.position[d] - plane) <= 0.0) continue;
      // One that starts behind the plane (a grown film) is put on it.
      const double beyond = std::min(outward * (flight.position[d] - plane),
                                     std::max(0.0, outward * dt * flight.velocity[d]));
      const double after = flight.velocity[d] == 0.0 ? 0.0 : beyond / std::abs(flight.velocity[d]);
      flight.position[d] = plane - outward * walls.retention_normal * beyond;
      if (outward * flight.velocity[d] > 0.0) {
        flight.velocity[d] *= -walls.retention_normal;
        for (int t = 0; t < 3; ++t) {
          if (t == d) continue;
          flight.position[t] -= after * (1.0 - walls.retention_tangential) * flight.velocity[t];
          flight.velocity[t] *= walls.retention_tangential;
        }
        ++flight.rebounds;
      }
    }
    // A box narrower than one step's path: the parcel ends at the wall that it met last.
    if (walls.side[d][0]) flight.position[d] = std::max(flight.position[d], grid.lo[d] + gap);
    if (walls.side[d][1]) flight.position[d] = std::min(flight.position[d], grid.hi[d] - gap);
  }
  return flight;
}

}  // namespace gasgrain
