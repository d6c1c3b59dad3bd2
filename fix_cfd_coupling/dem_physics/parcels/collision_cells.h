// What the collisions in a cell depend on: means over the parcels whose centres are in it.
//
//   u      mass-averaged velocity [m/s]
//   sigma  mass-weighted root-mean-square of |v - u| [m/s]
//   theta  volume fraction of the particles, films included
//   r_32   Sauter radius [m], sum N_p r^3 / sum N_p r^2
//   g_0    theta_cp / (theta_cp - theta), infinite at and beyond close packing
//
// Sources: O'Rourke, Zhao and Snider, Chem. Eng. Sci. 64 (2009) 1784, (4), (14), (15), (17), (19);
// g_0 as in O'Rourke and Snider, Chem. Eng. Sci. 65 (2010) 6014.
#pragma once

#include <vector>

#include "coupling/base/array3.h"
#include "coupling/base/tile_frame.h"
#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_view.h"

namespace gasgrain {

// The offset of the cell that holds each parcel in fields over the frame's tile.
std::vector<std::size_t> parcel_cells(const ParcelView& parcels, const TileFrame& frame);

struct CollisionCells {
  Array3<double> parcels;                  // in the cell
  Array3<double> mass;                     // [kg]
  std::array<Array3<double>, 3> velocity;  // u [m/s]
  Array3<double> variance;                 // sigma^2 [m2/s2]
  Array3<double> frequency;  // theta g_0 sigma / r_32 [1/s]; infinite at close packing, 0 at rest

  // Collective.
  CollisionCells(const ParcelView& parcels, const std::vector<std::size_t>& cells,
                 const TileFrame& frame, double close_packing, const SumOverRanks& sum);
};

}  // namespace gasgrain
