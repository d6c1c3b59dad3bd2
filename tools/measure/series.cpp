#include "tools/measure/series.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/error.h"
#include "tools/history.h"

namespace gasgrain {

std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<std::string>& names) {
  if (!std::filesystem::exists(file))
    fail("{} is absent: the script must write it by 'fix print'.", file.string());
  History history(file);
  history.read_on();
  std::vector<std::vector<double>> columns(names.size());
  std::vector<std::size_t> readings(names.size());
  for (std::size_t row = 0; row < history.rows(); ++row) {
    std::vector<double> line;
    for (std::size_t n = 0; n < names.size(); ++n)
      if (const auto value = history.value(row, names[n])) {
        line.push_back(*value);
        ++readings[n];
      }
    for (std::size_t n = 0; line.size() == names.size() && n < names.size(); ++n)
      columns[n].push_back(line[n]);
  }
  for (std::size_t n = 0; n < names.size(); ++n)
    if (readings[n] == 0) fail("{} has no numbers in a column {}.", file.string(), names[n]);
  if (columns.front().empty()) fail("{} has no whole line.", file.string());
  return columns;
}

BlockMean block_mean(const std::vector<double>& readings, int blocks) {
  const auto count = static_cast<std::size_t>(blocks);
  if (blocks < 2 || readings.size() < count)
    fail("{} readings cannot be split into {} blocks.", readings.size(), blocks);
  BlockMean mean;
  mean.value =
      std::accumulate(readings.begin(), readings.end(), 0.0) / static_cast<double>(readings.size());
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const auto from = readings.begin() + static_cast<long>(n * readings.size() / count);
    const auto to = readings.begin() + static_cast<long>((n + 1) * readings.size() / count);
    const double own = std::accumulate(from, to, 0.0) / static_cast<double>(to - from);
    sum += own;
    squares += own * own;
  }
  const auto b = static_cast<double>(blocks);
  mean.uncertainty = std::sqrt(std::max(0.0, squares - sum * sum / b) / (b - 1.0) / b);
  return mean;
}

}  // namespace gasgrain
