#include "gas_solver/turbulence/wall_sides.h"

#include <algorithm>

#include "coupling/base/error.h"
#include "gas_solver/boundary/inflow.h"

namespace gasgrain {
namespace {

// Ghost cells round a periodic axis stand for others.
Int3 inside(const BoxGrid& grid, Int3 cell) {
  for (int d = 0; d < 3; ++d) {
    const int n = grid.cells[d];
    cell[d] = grid.periodic[d] ? (cell[d] + ghost_layers * n) % n : std::clamp(cell[d], 0, n - 1);
  }
  return cell;
}

bool has_inflow(const GasInput& input, int side, const Int3& cell) {
  const Rectangle outline = face_rectangle(input.grid, side, cell);
  return std::any_of(input.inflows.begin(), input.inflows.end(), [&](const InflowPatch& patch) {
    return patch.side == side && common_area(patch.outline, outline) > 0;
  });
}

}  // namespace

WallSides::WallSides(const Domain& domain, const GasInput& input) {
  for (int side = 0; side < side_count; ++side) {
    if (!domain.touches(side) || !input.sides[side]->sticks) continue;
    const int axis = axis_of(side);
    IndexBox layer = domain.box();
    layer.lo[axis] = is_high(side) ? domain.own().hi[axis] - 1 : domain.own().lo[axis];
    layer.hi[axis] = layer.lo[axis] + 1;
    const double distance = 0.5 * domain.grid().spacing()[axis];
    WallSide wall{side, distance, input.wall_velocity[side], Array3<char>(layer),
                  Array3<double>(layer, input.viscosity / distance)};
    for_each_cell(layer, [&](int i, int j, int k) {
      wall.is_wall(i, j, k) = !has_inflow(input, side, inside(domain.grid(), {i, j, k}));
    });
    sides_.push_back(std::move(wall));
  }
}

const Array3<double>& WallSides::coefficient(int side) const {
  for (const WallSide& wall : sides_)
    if (wall.side == side) return wall.coefficient;
  fail("the gas does not stick to side {}, it has no wall stress.", side_names[side]);
}

}  // namespace gasgrain
