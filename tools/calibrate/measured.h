// What a run has measured: OUT/measured.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gasgrain {

// The values of these quantities. Throws an Error that names the nearest quantity, or all of the
// file, when one is not in it or is no finite number.
std::vector<double> measured_values(const std::filesystem::path& file,
                                    const std::vector<std::string>& names);

}  // namespace gasgrain
