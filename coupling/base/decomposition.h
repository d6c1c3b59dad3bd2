// Cuts a grid into one box of cells a rank.
#pragma once

#include <vector>

#include "coupling/base/box_grid.h"

namespace gasgrain {

// Boxes of nearly equal size (extents differ by at most one cell per axis), one a rank, x-rank
// fastest. The cut with the smallest area is taken; the longest axis is cut first. No box is
// thinner than `min_cells`; throws Error, which names the greatest number of ranks, when that
// cannot be.
std::vector<IndexBox> decompose(const BoxGrid& grid, int ranks, int min_cells = 2);

// Ranks per axis that decompose() chooses.
Int3 rank_layout(const BoxGrid& grid, int ranks, int min_cells = 2);

}  // namespace gasgrain
