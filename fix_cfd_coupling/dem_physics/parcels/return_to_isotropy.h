// Return of the velocities of a cell to an isotropic distribution by collisions.
//
//   d(sigma_ij - sigma^2/3 delta_ij)/dt = -(sigma_ij - sigma^2/3 delta_ij) / tau_G,
//   1/tau_G = 48 / (5 (3 pi)^(1/2)) eta (2 - eta) theta g_0 sigma / r_32,   eta = (1 + e) / 2
//
// Source: P. J. O'Rourke and D. M. Snider, Chem. Eng. Sci. 80 (2012) 39: in a step a parcel is
// redirected with the probability 1 - exp(-dt/tau_G), its velocity then being drawn from the
// isotropic normal distribution of the cell's mean and variance; all velocities of the cell are
// then shifted and scaled about the mean, so that momentum and energy are what they were, to
// round-off. tau_G / tau_D = 5/3 (1 - eta) / (2 - eta) as in the papers; the absolute value is that
// of kinetic theory for equal spheres (relaxation of the stress deviator,
// 16/5 n d^2 (pi T)^(1/2) at e = 1).
// `share`: the greatest probability in a step, the maximum momentum redirection from collision
// of MP-PIC codes (0.4: Alobaid 2013, table 10.4). A cell that it limits is counted.
// Deviations: sizes enter by r_32 alone. Nothing happens in cells with fewer than two parcels.
#pragma once

#include <cstdint>

#include "fix_cfd_coupling/dem_physics/parcels/collision_cells.h"

namespace gasgrain {

// Parcels of this rank.
struct IsotropyReport {
  std::size_t redirected = 0;
  std::size_t limited = 0;  // parcels in cells where the share was the limit
};

struct ReturnToIsotropy {
  double restitution;    // e, from 0 to 1
  double share;          // greatest probability to be redirected in a step, from 0 to 1
  double close_packing;  // of solids
  std::uint64_t seed;

  // 1/tau_G [1/s] of a cell whose theta g_0 sigma / r_32 is `frequency` [1/s].
  [[nodiscard]] double rate(double frequency) const;
  // Changes the velocities. step: the number of the step, for the random numbers. Collective.
  IsotropyReport redirect(const ParcelView& parcels, const std::vector<std::size_t>& cells,
                          const TileFrame& frame, double dt, std::uint64_t step,
                          const SumOverRanks& sum) const;
};

}  // namespace gasgrain
