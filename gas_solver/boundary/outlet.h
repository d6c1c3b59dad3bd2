// A side open to gas at rest of a given pressure.
//
// The face's velocity is an unknown of the momentum equation over the half cell inside the side.
// Gas that leaves takes its own momentum along (upwind). Gas that comes back enters normal to the
// face, its velocity along the side being 0, and carries half of the face's velocity: with the flux
// F [kg/(m2 s)] this costs F u / 2 = rho u^2 / 2, the pressure that draws gas out of rest
// (Bernoulli). The term opposes the flow whatever its size, so that backflow cannot feed itself.
#pragma once

#include "gas_solver/boundary/kind.h"

namespace gasgrain {

inline constexpr BoundaryKind outlet{"outlet", false, false, false};

// Share of the face's velocity that entering gas has already.
inline constexpr double backflow_share = 0.5;

}  // namespace gasgrain
