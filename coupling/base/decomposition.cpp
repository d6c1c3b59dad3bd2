#include "coupling/base/decomposition.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

// Nothing when no layout fits.
std::optional<Int3> best_layout(const BoxGrid& grid, int ranks, int min_cells) {
  std::optional<Int3> best;
  double least_area = std::numeric_limits<double>::infinity();
  for (int px = 1; px <= ranks; ++px) {
    if (ranks % px != 0) continue;
    for (int py = 1; py <= ranks / px; ++py) {
      if ((ranks / px) % py != 0) continue;
      const Int3 layout{px, py, ranks / px / py};
      bool fits = true;
      for (int d = 0; d < 3; ++d)
        fits = fits && (layout[d] == 1 || grid.cells[d] / layout[d] >= min_cells);
      if (!fits) continue;
      const double bx = double(grid.cells[0]) / layout[0];
      const double by = double(grid.cells[1]) / layout[1];
      const double bz = double(grid.cells[2]) / layout[2];
      const double area = (layout[0] > 1 ? by * bz : 0) + (layout[1] > 1 ? bx * bz : 0) +
                          (layout[2] > 1 ? bx * by : 0);
      if (area < least_area) {
        least_area = area;
        best = layout;
      }
    }
  }
  return best;
}

// The greatest number of ranks up to `most` for which a layout fits: for every cut of two axes the
// third is cut as often as it can be.
int greatest_that_fits(const BoxGrid& grid, int most, int min_cells) {
  const auto cuts = [&](int axis) { return std::max(1, grid.cells[axis] / min_cells); };
  int greatest = 1;
  for (int px = 1; px <= std::min(cuts(0), most); ++px)
    for (int py = 1; py <= std::min(cuts(1), most / px); ++py)
      greatest = std::max(greatest, px * py * std::min(cuts(2), most / (px * py)));
  return greatest;
}

}  // namespace

Int3 rank_layout(const BoxGrid& grid, int ranks, int min_cells) {
  if (const auto layout = best_layout(grid, ranks, min_cells)) return *layout;
  fail(
      "{} gas ranks cannot share a grid of {} x {} x {} cells with at least {} cells a side: use "
      "{}.",
      ranks, grid.cells[0], grid.cells[1], grid.cells[2], min_cells,
      greatest_that_fits(grid, ranks - 1, min_cells));
}

std::vector<IndexBox> decompose(const BoxGrid& grid, int ranks, int min_cells) {
  const Int3 layout = rank_layout(grid, ranks, min_cells);
  std::vector<IndexBox> boxes;
  for (int k = 0; k < layout[2]; ++k)
    for (int j = 0; j < layout[1]; ++j)
      for (int i = 0; i < layout[0]; ++i) {
        const Int3 at{i, j, k};
        IndexBox box;
        for (int d = 0; d < 3; ++d) {
          box.lo[d] = static_cast<int>(static_cast<long>(grid.cells[d]) * at[d] / layout[d]);
          box.hi[d] = static_cast<int>(static_cast<long>(grid.cells[d]) * (at[d] + 1) / layout[d]);
        }
        boxes.push_back(box);
      }
  return boxes;
}

}  // namespace gasgrain
