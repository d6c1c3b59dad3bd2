// The grids of the multigrid, from the finest to one cell, with room for their fields.
//
// A grid is coarsened along each axis whose spacing is less than 1.5 times the least, one axis
// after the other: the grids between are stages, not smoothed. Ranks coarsen their own boxes. A
// grid of few cells, or of which a rank might be left without a cell, is followed by the same one
// held by every rank.
#pragma once

#include "gas_solver/pressure/multigrid_grid.h"

namespace gasgrain {

std::vector<MultigridGrid> multigrid_hierarchy(const Domain& domain);

}  // namespace gasgrain
