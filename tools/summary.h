// The closing lines of a run that went well.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

// From history.csv: simulated time, bed height, overlap, momentum ledger; then the table of costs.
std::string summary(const std::filesystem::path& results, double wall_s, const std::string& costs);

// The paths of what the run made, a line each.
std::string made_files(const std::filesystem::path& results);

}  // namespace gasgrain
