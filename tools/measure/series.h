// Readings one after the other in time: columns of history.csv, and means with an honest error.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gasgrain {

// The columns of these names, in their order, of the lines that have all of them. Throws Error when
// the file or a column is absent, or no line is whole.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<std::string>& names);

struct BlockMean {
  double value = 0.0;
  double uncertainty = 0.0;  // standard error of the blocks' means
};

// Readings are split into `blocks` parts of the time, whose means are independent when a block is
// longer than what the readings remember. Needs at least as many readings as blocks, 2 or more.
BlockMean block_mean(const std::vector<double>& readings, int blocks);

}  // namespace gasgrain
