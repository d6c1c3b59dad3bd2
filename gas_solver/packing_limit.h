// Moves solids out of cells that hold more than can be.
//
// A method that gives a whole grain to one cell can fill small cells beyond any packing, and a
// grain of many cells has cells within it that are all solids. What is above the limit is handed to
// the six neighbours in equal parts (a side without a neighbour keeps its part), again until no
// cell is above it. The sum of solids is kept to round-off; every cell that was above is counted,
// for the report.
//
// The end of that handing over does not depend on its order (L. Levine, Y. Peres, Potential Anal.
// 30 (2009) 1, on divisible sandpiles): g, what a cell gives in all, is the least g >= 0 with
//
//   solids - (sum over the neighbours of g - g_neighbour) / 6 <= limit,
//
// equal where g > 0. So g is found instead, by over-relaxation of one half of a chequerboard after
// the other (of three colours where an odd number of cells is periodic): for a grain of 10 cells
// that takes 52 sweeps, handing over round by round 489.
//
// Why a limit: at eps -> 0 the drag laws and the gas's own inertia lose their meaning; nothing real
// is denser than `solids_limit` = 0.8 (equal spheres reach 0.74, bidisperse ones about 0.8).
#pragma once

#include "gas_solver/grid/halo.h"

namespace gasgrain {

inline constexpr double solids_limit = 0.8;
// Sweeps after which what is left is an error: the bed then holds more solids than it has room.
inline constexpr int packing_sweeps = 200;

// `solids`: volume fraction of solids over domain.box(); own cells are read and written, the layers
// around them are overwritten. Returns the own cells that were above the limit at first.
// Collective; throws Error when the solids do not fit.
long move_solids_above_limit(const Domain& domain, Halo& halo, Array3<double>& solids);

}  // namespace gasgrain
