// Fills the layers outside of the domain, after the halo. Cells there repeat the cell inside. Faces
// along a side mirror the face inside at the side's velocity U, 2 U - u, where the gas sticks to
// the side, and repeat it elsewhere; beyond a face on the side they repeat that face. All layers of
// one place hold the same value, so that a limiter which looks outside finds no slope and falls
// back to upwind.
#pragma once

#include "gas_solver/boundary/kinds.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

void fill_ghost_cells(const Domain& domain, Array3<double>& cells);
void fill_ghost_velocities(const Domain& domain, const Walls& walls, int component,
                           Array3<double>& velocity);
// Instead of the mirrored first layer outside of sides where the gas sticks, the value that a
// parabola through the side's velocity U and the two faces inside makes of it, u_1 / 3 - 2 u_0 +
// 8/3 U: differences across the side are then of second order there too, and the stress is that of
// the momentum equation (momentum/side_rows.h). Mirrored where there is one cell only.
void fill_parabolic_velocities(const Domain& domain, const Walls& walls, int component,
                               Array3<double>& velocity);
// Mass fluxes: repeated everywhere.
void fill_ghost_fluxes(const Domain& domain, int component, Array3<double>& flux);

}  // namespace gasgrain
