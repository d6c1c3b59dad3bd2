// One of the grids of the multigrid, the finest or a coarser one, in single precision.
//
// Every second point of a grid is a point of the next along the axis that is coarsened: cell i of
// the next lies where cell 2 i does. A rank holds those of its own box, and one layer round them.
// On the coarsest grids every rank holds the whole.
//
// The matrix is that of pressure_system.h; beyond the domain the solution is 0.
#pragma once

#include <vector>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct MultigridGrid {
  Int3 cells{};
  std::array<bool, 3> periodic{};
  bool whole = false;           // held by every rank
  std::vector<IndexBox> boxes;  // own cells of each rank, in the order of ranks
  IndexBox own;                 // of this rank
  bool relaxed = true;          // smoothed; else a stage on the way to a smoothed one
  int coarsened_along = -1;     // axis; -1: the last grid, or the next one is the same, whole
  float damping = 0;            // of the smoother, see multigrid_smoother.h

  std::array<Array3<float>, 3> face_coefficient;
  Array3<float> storage;           // own cells, or empty
  Array3<float> inverse_diagonal;  // of the smoother, where relaxed
  // Share of a cell between two cells of the next grid, at odd places along the axis, in the lower
  // and the higher one; it interpolates corrections and distributes what is left.
  Array3<float> to_low, to_high;

  Array3<float> source;  // but for the finest grid, whose source is given in double precision
  Array3<float> solution;
  Array3<float> rest;  // source - matrix times solution, where relaxed

  [[nodiscard]] bool touches(int side) const {
    const int axis = axis_of(side);
    if (periodic[axis]) return false;
    return is_high(side) ? own.hi[axis] == cells[axis] : own.lo[axis] == 0;
  }
  // Low faces of the own cells, and the faces of the domain's sides.
  [[nodiscard]] IndexBox faces(int axis) const {
    IndexBox held = own;
    if (touches(side_of(axis, true))) ++held.hi[axis];
    return held;
  }
  // What the next grid is to be a correction for.
  [[nodiscard]] const Array3<float>& left() const { return relaxed ? rest : source; }
  Array3<float>& left() { return relaxed ? rest : source; }
};

}  // namespace gasgrain
