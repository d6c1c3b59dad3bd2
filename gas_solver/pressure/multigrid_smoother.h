// The smoother of the multigrid: Gauss-Seidel from row to row of cells along x, Jacobi within a
// row, where all cells of a row go through the vector unit side by side. In cell i of a row
//   x_i = (source_i + sum over the neighbours of c x_neighbour) / (d_i + damping (c_i + c_i+1)),
// d the diagonal, c_i and c_i+1 the coefficients along x; of neighbours in rows that were visited
// before the new values count, of the others the old ones. Across the cut between ranks, and round
// a periodic axis, the old ones.
//
// One sweep downwards from 0 before the correction by coarser grids and one sweep upwards after it
// are each other's transpose: the whole is symmetric, as conjugate gradients need it, and positive
// definite, since 2 (diagonal + damping) - matrix of the rows' couplings is so for damping >= 0.
// Damping is needed where x couples more than the other axes together: there Jacobi leaves cells of
// alternating sign as they are.
#pragma once

#include "gas_solver/pressure/multigrid_halo.h"

namespace gasgrain {

// The inverse diagonal from the matrix.
void set_diagonal(MultigridGrid& grid);

// The solution after a sweep downwards from 0, and what it leaves. `source`: own cells, or more.
// Collective.
template <class T>
void relax_from_zero(MultigridGrid& grid, const Array3<T>& source, MultigridHalo& halo);

// A sweep upwards on the solution; returns this rank's product of source and solution.
// Collective.
template <class T>
double relax(MultigridGrid& grid, const Array3<T>& source, MultigridHalo& halo);

}  // namespace gasgrain
