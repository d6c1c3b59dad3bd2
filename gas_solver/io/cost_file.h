// What the gas solver spent its time on: the table at the end of a run, and ledger.json.
#pragma once

#include <string>

#include "coupling/base/cost_ledger.h"

namespace gasgrain {

// Closes the ledger and prints its table; returns it as a JSON object (on rank 0; empty elsewhere).
// Collective.
std::string told_costs(CostLedger& costs, const Communicator& comm);

// The same for a run of the gas alone, which writes `<folder>/ledger.json` itself; throws Error
// when it cannot. Collective.
void write_costs(CostLedger& costs, const std::string& folder, const Communicator& comm);

}  // namespace gasgrain
