// What a host supplies of its parcels: clouds of equal particles that move as one point.
//
// Radius, mass and solid volume are those of ONE particle, film included in the first two; what a
// parcel carries of them is N_p times as much. Arrays are the host's own, nothing is copied.
#pragma once

#include <cmath>
#include <cstddef>

#include "coupling/base/vec3.h"

namespace gasgrain {

struct ParcelView {
  std::size_t count = 0;                 // parcels of this rank
  double* position = nullptr;            // [m], count x 3
  double* velocity = nullptr;            // [m/s], count x 3
  const double* radius = nullptr;        // [m], of a particle, film included
  const double* mass = nullptr;          // [kg], of a particle, film included
  const double* solid_volume = nullptr;  // [m3], of a particle's solid core
  const double* particles = nullptr;     // N_p, particles a parcel; need not be whole
  const int* number = nullptr;           // unique in the run: names the random numbers of a parcel

  [[nodiscard]] Vec3 x(std::size_t p) const { return Vec3(position + 3 * p); }
  [[nodiscard]] Vec3 v(std::size_t p) const { return Vec3(velocity + 3 * p); }
  // Volume of a particle, film included [m3].
  [[nodiscard]] double particle_volume(std::size_t p) const {
    return 4.0 / 3.0 * M_PI * radius[p] * radius[p] * radius[p];
  }
  // Solid volume of all particles of the parcel [m3].
  [[nodiscard]] double solids(std::size_t p) const { return particles[p] * solid_volume[p]; }
  // Mass of all particles of the parcel [kg].
  [[nodiscard]] double parcel_mass(std::size_t p) const { return particles[p] * mass[p]; }
};

}  // namespace gasgrain
