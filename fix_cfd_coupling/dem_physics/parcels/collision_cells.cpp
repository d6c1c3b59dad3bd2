#include "fix_cfd_coupling/dem_physics/parcels/collision_cells.h"

#include <limits>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_deposit.h"

namespace gasgrain {

std::vector<std::size_t> parcel_cells(const ParcelView& parcels, const TileFrame& frame) {
  std::vector<std::size_t> cells(parcels.count);
  const Array3<char> tile(frame.tile);
  for (std::size_t p = 0; p < parcels.count; ++p) {
    Int3 cell;
    for (int d = 0; d < 3; ++d)
      cell[d] = frame.cell(frame.in_cells(parcels.position[3 * p + d], d), d);
    if (!frame.tile.contains(cell[0], cell[1], cell[2]))
      fail(
          "a parcel in cell ({}, {}, {}) is outside of the cells that its rank holds: hand parcels "
          "to the ranks that own their places before their collisions.",
          cell[0], cell[1], cell[2]);
    cells[p] = static_cast<std::size_t>(tile.offset(cell[0], cell[1], cell[2]));
  }
  return cells;
}

CollisionCells::CollisionCells(const ParcelView& view, const std::vector<std::size_t>& cells,
                               const TileFrame& frame, double close_packing,
                               const SumOverRanks& sum) {
  Array3<double> volume(frame.tile, 0.0);
  Array3<double> solids(frame.tile, 0.0);
  Array3<double> cubes(frame.tile, 0.0);
  Array3<double> squares(frame.tile, 0.0);
  for (Array3<double>* field :
       {&parcels, &mass, &velocity[0], &velocity[1], &velocity[2], &variance, &frequency})
    clear(*field, frame);

  for (std::size_t p = 0; p < view.count; ++p) {
    const std::size_t c = cells[p];
    const double m = view.parcel_mass(p);
    const double r = view.radius[p];
    parcels[c] += 1.0;
    mass[c] += m;
    for (int d = 0; d < 3; ++d) velocity[d][c] += m * view.velocity[3 * p + d];
    volume[c] += view.particles[p] * view.particle_volume(p);
    solids[c] += view.solids(p);
    cubes[c] += view.particles[p] * r * r * r;
    squares[c] += view.particles[p] * r * r;
  }
  sum({&parcels, &mass, &velocity[0], &velocity[1], &velocity[2], &volume, &solids, &cubes,
       &squares});
  for (std::size_t c = 0; c < mass.size(); ++c)
    if (mass[c] > 0.0)
      for (int d = 0; d < 3; ++d) velocity[d][c] /= mass[c];

  for (std::size_t p = 0; p < view.count; ++p) {
    const std::size_t c = cells[p];
    double square = 0.0;
    for (int d = 0; d < 3; ++d) {
      const double fluctuation = view.velocity[3 * p + d] - velocity[d][c];
      square += fluctuation * fluctuation;
    }
    variance[c] += view.parcel_mass(p) * square;
  }
  sum({&variance});

  const double cell_volume = frame.grid.cell_volume();
  for (std::size_t c = 0; c < mass.size(); ++c) {
    if (mass[c] <= 0.0) continue;
    variance[c] /= mass[c];
    if (parcels[c] < 1.5 || variance[c] <= 0.0) continue;
    const double theta = volume[c] / cell_volume;
    // (17); where there are no solids the particles are drops, which may fill the cell.
    const double packed =
        solids[c] > 0.0 ? std::min(close_packing * volume[c] / solids[c], 1.0) : 1.0;
    const double radius = cubes[c] / squares[c];
    frequency[c] = theta < packed
                       ? theta * packed / (packed - theta) * std::sqrt(variance[c]) / radius
                       : std::numeric_limits<double>::infinity();
  }
}

}  // namespace gasgrain
