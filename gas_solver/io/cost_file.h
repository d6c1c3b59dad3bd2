// ledger.gas.json: the gas solver's seconds by task.
#pragma once

#include <string>

#include "coupling/base/cost_ledger.h"

namespace gasgrain {

// Writes `<folder>/ledger.gas.json`; throws Error when it cannot. Collective.
void write_costs(const CostLedger& costs, const std::string& folder, const Communicator& comm);

}  // namespace gasgrain
