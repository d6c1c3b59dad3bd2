// What the wall time of a run was spent on: the two sides' ledgers made one.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

// Merges ledger.dem.json and ledger.gas.json into ledger.json,
//   {"wall_s": .., "dem": {..}, "gas": {..}},
// removes the parts, and returns the table of costs for the summary. A side that wrote none is left
// out; without either there is no ledger.json and the table is empty.
std::string merge_ledgers(const std::filesystem::path& results, double wall_s);

}  // namespace gasgrain
