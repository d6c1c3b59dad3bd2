// The two sides of an axis joined: what leaves by one enters by the other. Both must say so.
#pragma once

#include "gas_solver/boundary/kind.h"

namespace gasgrain {

inline constexpr BoundaryKind periodic_side{"periodic", false, false, true};

}  // namespace gasgrain
