// A wall that the gas sticks to: u = 0. Its shear stress is mu u_t / (h / 2), first order at the
// wall cell. Patches of inflow may lie in it.
#pragma once

#include "gas_solver/boundary/kind.h"

namespace gasgrain {

inline constexpr BoundaryKind wall_no_slip{"no_slip", true, true, false};

}  // namespace gasgrain
