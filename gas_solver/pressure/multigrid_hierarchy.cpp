#include "gas_solver/pressure/multigrid_hierarchy.h"

#include "coupling/base/decomposition.h"

namespace gasgrain {
namespace {

// Axes of greater spacing than this times the least are coupled too weakly to be coarsened.
constexpr double greatest_spacing = 1.5;
// Grids of no more cells than this in all are held by every rank: to work them off costs less than
// the messages.
constexpr std::size_t cells_to_gather = 4000;
// Of the smoother, where x couples more than the other axes together.
constexpr float damping_along_x = 0.25F;

IndexBox coarsened(IndexBox box, int axis) {
  box.lo[axis] = (box.lo[axis] + 1) / 2;
  box.hi[axis] = (box.hi[axis] + 1) / 2;
  return box;
}

std::size_t size_of(const Int3& cells) {
  return IndexBox{{0, 0, 0}, cells}.size();
}

// Axes to coarsen, of a grid of this spacing.
std::array<bool, 3> axes_to_coarsen(const Int3& cells, const Vec3& spacing) {
  double least = 0;
  for (int d = 0; d < 3; ++d)
    if (cells[d] > 1 && (least == 0 || spacing[d] < least)) least = spacing[d];
  std::array<bool, 3> axes{};
  for (int d = 0; d < 3; ++d) axes[d] = cells[d] > 1 && spacing[d] < greatest_spacing * least;
  return axes;
}

float damping(const Int3& cells, const Vec3& spacing) {
  double others = 0;
  for (const int d : {1, 2})
    if (cells[d] > 1) others += 1 / (spacing[d] * spacing[d]);
  return 1 / (spacing[0] * spacing[0]) > 1.001 * others ? damping_along_x : 0.0F;
}

void allocate(MultigridGrid& grid, bool has_source) {
  const IndexBox box = grid.own.grown(1);
  for (Array3<float>& c : grid.face_coefficient) c = Array3<float>(box);
  grid.solution = Array3<float>(box);
  if (has_source) grid.source = Array3<float>(box);
  if (grid.relaxed)
    for (Array3<float>* field : {&grid.inverse_diagonal, &grid.rest}) *field = Array3<float>(box);
  if (grid.coarsened_along >= 0)
    for (Array3<float>* shares : {&grid.to_low, &grid.to_high}) *shares = Array3<float>(box);
}

bool is_to_gather(const MultigridGrid& grid, const std::array<bool, 3>& axes) {
  if (grid.whole) return false;
  if (size_of(grid.cells) <= cells_to_gather) return true;
  for (const IndexBox& box : grid.boxes)
    for (int d = 0; d < 3; ++d)
      if (axes[d] && box.extent(d) < 2) return true;  // may hold no cell of the next grid
  return false;
}

}  // namespace

std::vector<MultigridGrid> multigrid_hierarchy(const Domain& domain) {
  std::vector<MultigridGrid> grids;
  Vec3 spacing = domain.grid().spacing();
  MultigridGrid grid;
  grid.cells = domain.grid().cells;
  grid.periodic = domain.grid().periodic;
  grid.boxes = decompose(domain.grid(), domain.comm().size());
  grid.own = domain.own();
  grid.whole = domain.comm().size() == 1;
  grid.damping = damping(grid.cells, spacing);
  grids.push_back(grid);
  while (size_of(grid.cells) > 1) {
    const std::array<bool, 3> axes = axes_to_coarsen(grid.cells, spacing);
    if (is_to_gather(grid, axes)) {
      if (grids.size() > 1) grids.back().relaxed = false;
      grid.whole = true;
      grid.own = {{0, 0, 0}, grid.cells};
      grid.boxes = {grid.own};
      grids.push_back(grid);
    }
    for (int axis = 2; axis >= 0; --axis) {  // last along x, whose cells lie apart in memory
      if (!axes[axis]) continue;
      grids.back().coarsened_along = axis;
      grid.cells[axis] = (grid.cells[axis] + 1) / 2;
      spacing[axis] *= 2;
      grid.own = coarsened(grid.own, axis);
      for (IndexBox& box : grid.boxes) box = coarsened(box, axis);
      grids.push_back(grid);
      grids.back().relaxed = false;
    }
    grids.back().relaxed = true;
    grids.back().damping = grid.damping = damping(grid.cells, spacing);
  }
  for (MultigridGrid& each : grids) allocate(each, &each != &grids.front());
  return grids;
}

}  // namespace gasgrain
