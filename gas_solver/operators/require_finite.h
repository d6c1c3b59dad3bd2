// Stops a run whose fields are no numbers any more, and says where.
#pragma once

#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

// Throws the same GasFault, of the first cell at fault, on every rank. Collective.
void require_finite(const Domain& domain, const GasState& state, double time);

}  // namespace gasgrain
