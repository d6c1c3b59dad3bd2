// The cells of a collective effect (dem_physics) as a rank of the host holds them: the grid, the
// rank's tile of it, and the sums over ranks that share cells.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "coupling/base/tile_frame.h"
#include "coupling/transport/tile_sums.h"
#include "fix_cfd_coupling/dem_physics/cell_sums.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// `own` cells over the host's box, or without them the grid of the script's couple/gas. Throws
// Error when there is neither; `who`: the fix that asks.
BoxGrid grid_of_scene(LAMMPS_NS::LAMMPS& host, const std::optional<Int3>& own,
                      std::string_view who);

class RankCells {
 public:
  // Collective over the host's ranks.
  RankCells(LAMMPS_NS::LAMMPS& host, const BoxGrid& grid);

  // Fits the tile to the rank's sub-domain: parcels may be `drift` [m] outside of it, and their
  // stencils reach `reach` cells further. Collective.
  void follow_domain(double drift, int reach);

  [[nodiscard]] const TileFrame& frame() const { return frame_; }
  // Of the cell that holds a point, into fields over the tile. Throws Error when it is outside.
  [[nodiscard]] std::uint32_t offset(const double* x) const;
  // Valid as long as this object.
  SumOverRanks sum();

 private:
  LAMMPS_NS::LAMMPS& host_;
  TileFrame frame_;
  TileSums sums_;
};

}  // namespace gasgrain
