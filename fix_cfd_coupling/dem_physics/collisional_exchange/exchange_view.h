// What a host supplies of its particles to the collisional exchange: arrays of its own, one entry a
// parcel, nothing copied. A parcel is N_p particles of the same properties; in a DEM run a particle
// is a parcel of one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "coupling/base/box_grid.h"

namespace gasgrain {

// The cell of a parcel that takes no part.
constexpr std::uint32_t no_cell = 0xffffffffU;

struct ExchangeView {
  std::size_t count = 0;                 // parcels of this rank
  const double* particles = nullptr;     // N_p, particles a parcel; null: 1 each
  const double* solid_mass = nullptr;    // M_s [kg], of one particle
  const double* solid_volume = nullptr;  // M_s / rho_s [m3], of one particle
  double* film_mass = nullptr;           // M_f,i [kg], of one particle: count x species
  double* velocity = nullptr;            // u [m/s], count x 3
  double* film_temperature = nullptr;    // T_f [K]; null when the scene has no temperatures
  const std::uint32_t* cell = nullptr;   // offset into arrays over the tile, or no_cell
  // True: films have inertia, M_p = M_s + sum M_f,i. False in DEM runs, where the host's mass of a
  // grain stays that of the solid: M_p = M_s in (4), (14) and (56).
  bool film_has_inertia = true;
};

// Throws Error when a mass, a volume or N_p is negative or not finite, a temperature is not above
// 0, or a cell is out of the tile: for the beginning of a run, since it reads everything.
void check_view(const ExchangeView& view, std::size_t species, const IndexBox& tile);

}  // namespace gasgrain
