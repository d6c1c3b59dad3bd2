// What the wall time of a run was spent on.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

// Adds the launch's wall time to ledger.json, which the programs wrote,
//   {"wall_s": .., "dem": {..}, "gas": {..}},
// and returns the tables of costs for the summary. A run that did not come to its orderly end wrote
// none: the text is then empty.
std::string finish_ledger(const std::filesystem::path& results, double wall_s);

}  // namespace gasgrain
