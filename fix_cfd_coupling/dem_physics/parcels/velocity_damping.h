// Damping of velocity fluctuations by inelastic collisions, in each cell.
//
//   d(sigma^2)/dt = -sigma^2 / tau_D,
//   1/tau_D = 16 / (3 pi)^(1/2) eta (1 - eta) theta g_0 sigma / r_32,   eta = (1 + e) / 2
//
// Source: P. J. O'Rourke and D. M. Snider, Chem. Eng. Sci. 65 (2010) 6014, in the form for
// velocities near equilibrium that MP-PIC codes document. It is the loss of energy of granular
// kinetic theory (Lun, Savage, Jeffrey and Chepurniy, J. Fluid Mech. 140 (1984) 223),
// 12 (1 - e^2) theta^2 rho g_0 T^(3/2) / (d pi^(1/2)) over 3/2 rho theta T, with sigma^2 = 3 T.
//
// Every parcel of the cell: v -> u + (v - u) / (1 + dt/tau_D)^(1/2), tau_D of the step's beginning:
// sigma^2 decays by 1 / (1 + dt/tau_D), stable at any step, and to rest at close packing.
// Conserves each cell's momentum to round-off. Nothing happens to a parcel alone in its cell.
// Deviations: no separate form for beams that cross (the 2010 paper's second time scale); sizes
// enter by r_32 alone. Codes that relax velocities with 1/tau_D lose energy twice as fast.
#pragma once

#include "fix_cfd_coupling/dem_physics/parcels/collision_cells.h"

namespace gasgrain {

struct VelocityDamping {
  double restitution;    // e, from 0 to 1
  double close_packing;  // of solids

  // tau_D of a cell whose theta g_0 sigma / r_32 is `frequency` [1/s]: 1/tau_D [1/s].
  [[nodiscard]] double rate(double frequency) const;
  // Changes the velocities; returns the energy lost by the parcels of this rank, all particles [J].
  // Collective.
  double damp(const ParcelView& parcels, const std::vector<std::size_t>& cells,
              const TileFrame& frame, double dt, const SumOverRanks& sum) const;
};

}  // namespace gasgrain
