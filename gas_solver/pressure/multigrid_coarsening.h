// From a grid of the multigrid to the next along one axis, and back: semicoarsening with
// interpolation that follows the coefficients.
//
// A cell between two cells of the next grid takes its value from theirs as in one dimension, so
// that the flux through it is continuous:
//   x = (c_low x_low + c_high x_high) / (c_low + c_high).
// What is left of its source goes to the two with the same shares: restriction is the transpose.
// The coefficient between the two is that of both faces in series, c_low c_high / (c_low + c_high);
// those of its other faces, and its storage, go to the two with the shares (of a face, with the
// mean shares of its two cells). Shares that follow the coefficients keep bubbles apart from the
// bed: with the lesser of the two cells' shares conjugate gradients need 3 times the iterations at
// a contrast of 10000, with one half everywhere twice.
#pragma once

#include "gas_solver/pressure/multigrid_halo.h"

namespace gasgrain {

// Fills shares of `fine` and the matrix of `coarse` from that of `fine`. Collective.
void coarsen(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo);
// coarse.source from what is left on the fine grid. Collective.
void restrict_rest(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo);
// Adds coarse.solution to the solution of a relaxed grid, else sets it. Collective.
void correct(MultigridGrid& fine, MultigridGrid& coarse, MultigridHalo& halo);

}  // namespace gasgrain
