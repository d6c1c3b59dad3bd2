// The LIST of boundary kinds: what [boundary] of gas.toml may say of a side.
#pragma once

#include <array>

#include "coupling/base/vec3.h"
#include "gas_solver/boundary/outlet.h"
#include "gas_solver/boundary/periodic.h"
#include "gas_solver/boundary/wall_free_slip.h"
#include "gas_solver/boundary/wall_no_slip.h"

namespace gasgrain {

inline constexpr std::array<const BoundaryKind*, 4> boundary_kinds{
    &wall_no_slip,
    &wall_free_slip,
    &outlet,
    &periodic_side,
};

// The kinds of the six sides of a domain, in the order of side_names.
using Sides = std::array<const BoundaryKind*, 6>;

// The sides with the velocities at which their walls move along themselves [m/s].
struct Walls {
  Sides sides;
  std::array<Vec3, 6> velocity;
};

}  // namespace gasgrain
