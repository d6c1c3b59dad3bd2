// Moves solids out of cells that hold more than can be.
//
// A method that gives a whole grain to one cell can fill small cells beyond any packing. What is
// above the limit is handed to the six neighbours in equal parts (a side without a neighbour keeps
// its part), again until no cell is above it. The sum of solids is kept to round-off; every cell
// that gave something away is counted, for the report.
//
// Why a limit: at eps -> 0 the drag laws and the gas's own inertia lose their meaning; nothing real
// is denser than `solids_limit` = 0.8 (equal spheres reach 0.74, bidisperse ones about 0.8).
#pragma once

#include "gas_solver/grid/halo.h"

namespace gasgrain {

inline constexpr double solids_limit = 0.8;
// Passes after which what is left is an error: the bed then holds more solids than it has room.
inline constexpr int packing_passes = 200;

// `solids`: volume fraction of solids over domain.box(); own cells are read and written, the layers
// around them are overwritten. Returns the own cells that were above the limit at first.
// Collective; throws Error when the solids do not fit.
long move_solids_above_limit(const Domain& domain, Halo& halo, Array3<double>& solids);

}  // namespace gasgrain
