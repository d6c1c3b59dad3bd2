// A wall without shear, or a plane of symmetry: the normal velocity is 0, the shear stress is 0.
// Patches of inflow may lie in it.
#pragma once

#include "gas_solver/boundary/kind.h"

namespace gasgrain {

inline constexpr BoundaryKind wall_free_slip{"free_slip", true, false, false};

}  // namespace gasgrain
