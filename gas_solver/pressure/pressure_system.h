// The Poisson equation of a step, cell by cell:
//   storage x_cell + sum over the faces of c_f (x_cell - x_neighbour) = source,
// c_f = 0 on faces of given velocity, and on those of a cell that is its own neighbour round a
// periodic axis; a face of given pressure has the neighbour value 0. `storage` is what a
// compressible cell takes up (a Helmholtz equation); without it the field is empty.
#pragma once

#include "gas_solver/boundary/kinds.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

struct PressureSystem {
  explicit PressureSystem(const Domain& domain, const Sides& kinds) : sides(kinds) {
    for (auto& c : face_coefficient) c = Array3<double>(domain.box());
    source = Array3<double>(domain.own());
    solution = Array3<double>(domain.box());
  }
  std::array<Array3<double>, 3> face_coefficient;  // all faces of the own cells, low and high
  Array3<double> storage;                          // own cells, or empty
  Array3<double> source;                           // own cells
  Array3<double> solution;                         // own cells are set by a solver
  Sides sides;
  // No storage, and no face has a given pressure: the solution is known but for a constant.
  bool singular = false;
};

inline bool has_storage(const PressureSystem& system) {
  return system.storage.size() > 0;
}

// The coefficient of the cell's own value.
inline double diagonal(const PressureSystem& system, int i, int j, int k) {
  const auto o = system.solution.offset(i, j, k);
  double sum = has_storage(system) ? system.storage(i, j, k) : 0.0;
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& c = system.face_coefficient[d];
    sum += c[o] + c[o + c.stride(d)];
  }
  return sum;
}

}  // namespace gasgrain
