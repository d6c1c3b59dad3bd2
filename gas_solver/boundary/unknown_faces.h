// The faces of a rank whose velocity the equations decide: those between two cells, and those of a
// side that does not give its normal velocity.
#pragma once

#include "gas_solver/boundary/kinds.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

inline IndexBox unknown_faces(const Domain& domain, const Sides& sides, int axis) {
  IndexBox faces = domain.inner_faces(axis);
  const int lo = side_of(axis, false);
  const int hi = side_of(axis, true);
  if (domain.touches(lo) && !sides[lo]->normal_velocity_given) --faces.lo[axis];
  if (domain.touches(hi) && !sides[hi]->normal_velocity_given) ++faces.hi[axis];
  return faces;
}

}  // namespace gasgrain
