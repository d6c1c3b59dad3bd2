// How far the films of a cell are from the local equilibrium: the normalised standard deviation of
// the liquid, (62) of O'Rourke, Zhao and Snider, Chem. Eng. Sci. 64 (2009) 1784.
//
//   eta = [sum N_p (M_f - lambda M_s)^2]^(1/2) / sum N_p M_f
//
// M_f is all the liquid of a particle. No unit; 0 in equilibrium, without liquid, and where there
// is liquid without solid mass, which has no lambda. As printed, the root is not divided by a
// number of particles: eta falls with the square root of how many are in a cell.
#pragma once

#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_cells.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_view.h"

namespace gasgrain {

// Of the view after the step that left `cells`, over their tile. Collective.
void liquid_spread(const ExchangeView& view, const ExchangeCells& cells, const SumOverRanks& sum,
                   Array3<double>& eta);

}  // namespace gasgrain
