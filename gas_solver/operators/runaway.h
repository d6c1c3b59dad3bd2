// Stops a gas that runs away before it costs hours or ends in no numbers.
//
// The step is split so that the Courant number stays below [time] courant_max: a flow that runs
// away shows in ever shorter steps. When a step of [time] step, or the interval where that is
// shorter, would be split into more than [time] substeps_max, the flow crosses courant_max
// substeps_max cells in it: with the defaults, 20 x 1000 cells of 4 mm in 1 ms, 80 km/s.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

// Greatest |u| / h of the faces of all ranks [1/s]. Collective.
double courant_rate(const Domain& domain, const CellVector& velocity);

struct CourantRates {
  double flow = 0;    // of the faces [1/s]
  double inflow = 0;  // of what the step to come lets in [1/s]
};

// Throws the same GasFault on every rank, with the cell of the fastest face. Collective only where
// it throws: `rates` are those of all ranks.
void require_bounded(const Domain& domain, const GasInput& input, const CellVector& velocity,
                     const CourantRates& rates, double interval, double time);

}  // namespace gasgrain
