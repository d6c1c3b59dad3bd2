#include "fix_cfd_coupling/fixes/rank_cells.h"

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "domain.h"
#include "modify.h"

namespace gasgrain {

BoxGrid grid_of_scene(LAMMPS_NS::LAMMPS& host, const std::optional<Int3>& own,
                      std::string_view who) {
  const LAMMPS_NS::Domain& domain = *host.domain;
  if (!own) {
    for (int n = 0; n < host.modify->nfix; ++n)
      if (const auto* gas = dynamic_cast<LAMMPS_NS::FixCoupleGas*>(host.modify->fix[n]))
        return gas->grid();
    fail(
        "{} has no cells: there is no couple/gas in the script whose grid it could take. Add "
        "'cells NX NY NZ', the numbers of cells over the box.",
        who);
  }
  if (domain.nonperiodic == 2)
    fail("{}: the box may not follow the particles: use 'boundary f f f' (or p), not s or m.", who);
  BoxGrid grid;
  for (int d = 0; d < 3; ++d) {
    grid.lo[d] = domain.boxlo[d];
    grid.hi[d] = domain.boxhi[d];
    grid.periodic[d] = domain.periodicity[d] != 0;
  }
  grid.cells = *own;
  return grid;
}

namespace {

TileSums sums_over(const BoxGrid& grid) {
  const Communicator& ranks = session().local;
  try {
    return {ranks, grid};
  } catch (const Error&) {
    fail(
        "{} ranks cannot share the {} x {} x {} cells that parcels and their exchange are summed "
        "over: take more cells, or fewer ranks.",
        ranks.size(), grid.cells[0], grid.cells[1], grid.cells[2]);
  }
}

}  // namespace

RankCells::RankCells(LAMMPS_NS::LAMMPS& host, const BoxGrid& grid)
    : host_(host), frame_{grid, {}}, sums_(sums_over(grid)) {}

void RankCells::follow_domain(double drift, int reach) {
  const BoxGrid& grid = frame_.grid;
  IndexBox tile;
  for (int d = 0; d < 3; ++d) {
    tile.lo[d] = grid.cell_of(host_.domain->sublo[d] - drift, d) - reach;
    tile.hi[d] = grid.cell_of(host_.domain->subhi[d] + drift, d) + 1 + reach;
    if (grid.periodic[d]) continue;
    tile.lo[d] = std::clamp(tile.lo[d], 0, grid.cells[d] - 1);
    tile.hi[d] = std::clamp(tile.hi[d], tile.lo[d] + 1, grid.cells[d]);
  }
  frame_.tile = tile;
  sums_.set_tile(tile);
}

std::uint32_t RankCells::offset(const double* x) const {
  Int3 cell;
  for (int d = 0; d < 3; ++d) cell[d] = frame_.cell(frame_.in_cells(x[d], d), d);
  const IndexBox& tile = frame_.tile;
  if (!tile.contains(cell[0], cell[1], cell[2]))
    fail(
        "a particle at x = {:g}, y = {:g}, z = {:g} m is far outside of its rank's part of the box",
        x[0], x[1], x[2]);
  return static_cast<std::uint32_t>(
      (cell[0] - tile.lo[0]) +
      tile.extent(0) * ((cell[1] - tile.lo[1]) + tile.extent(1) * (cell[2] - tile.lo[2])));
}

SumOverRanks RankCells::sum() {
  return [this](const std::vector<Array3<double>*>& fields) { sums_.add_up(fields); };
}

}  // namespace gasgrain
