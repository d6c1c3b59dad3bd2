// What the velocity of faces makes of a cell. Each call adds `weight` times the value of the own
// cells to `sum`. The velocity's layers must be filled (boundary/ghosts.h), at walls by parabolas.
#pragma once

#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

// u [m/s], the mean of the cell's two faces.
void add_cell_velocity(const Domain& domain, const CellVector& u, double weight, CellVector& sum);
// curl u [1/s].
void add_vorticity(const Domain& domain, const CellVector& u, double weight, CellVector& sum);
// u . grad u [m/s2].
void add_convection(const Domain& domain, const CellVector& u, double weight, CellVector& sum);
// div tau [N/m3], tau = mu (grad u + grad u^T - 2/3 div u) of a constant mu: mu (laplace u + 1/3
// grad div u). The mean of the cell's two faces, in each of which it is second order; a face on a
// side takes the value of the cell's opposite face. First order in the cells at the sides, exact
// for a parabola from a wall.
void add_viscous_force(const Domain& domain, const CellVector& u, double viscosity, double weight,
                       CellVector& sum);

}  // namespace gasgrain
