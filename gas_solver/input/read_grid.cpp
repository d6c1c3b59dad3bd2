#include "coupling/base/error.h"
#include "gas_solver/input/readers.h"
#include "gas_solver/plane_of_spheres.h"

namespace gasgrain {
namespace {

void make_plane(InputTable& table, GasInput& input) {
  BoxGrid& grid = input.grid;
  if (grid.cells[1] != 1) {
    table.fault("plane_of_spheres",
                fmt::format("grid.plane_of_spheres needs one cell along y, the grid has {}: set "
                            "grid.cells to [{}, 1, {}], or leave the key out.",
                            grid.cells[1], grid.cells[0], grid.cells[2]));
    return;
  }
  const double middle = 0.5 * (grid.lo[1] + grid.hi[1]);
  const double depth = plane_depth_in_diameters * input.plane_of_spheres;
  grid.lo[1] = middle - 0.5 * depth;
  grid.hi[1] = middle + 0.5 * depth;
}

}  // namespace

bool read_grid(InputTable table, GasInput& input) {
  BoxGrid& grid = input.grid;
  grid.lo = table.vec3("lo", std::nullopt, Range::any(), "m");
  grid.hi = table.vec3("hi", std::nullopt, Range::any(), "m");
  grid.cells = table.int3("cells", std::nullopt, Range::within(1, 100000));
  input.plane_of_spheres = table.number("plane_of_spheres", 0.0, Range::positive(), "m");
  table.note_default("plane_of_spheres", "none");
  bool usable = true;
  for (const char* key : {"lo", "hi", "cells"})
    usable = usable && table.has(key) && !table.at_fault(key);
  for (int d = 0; d < 3 && usable; ++d) {
    if (!(grid.hi[d] > grid.lo[d])) {
      table.fault("hi", fmt::format("grid.hi must be above grid.lo along {}, but {} <= {}.",
                                    "xyz"[d], grid.hi[d], grid.lo[d]));
      usable = false;
    }
  }
  if (!usable) grid = BoxGrid{};
  if (usable && input.plane_of_spheres > 0) make_plane(table, input);
  return usable;
}

}  // namespace gasgrain
