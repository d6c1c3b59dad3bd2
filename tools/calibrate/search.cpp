#include "tools/calibrate/search.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace gasgrain {

std::string values_text(const CalibrationProblem& problem, const std::vector<double>& values) {
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < values.size(); ++n)
    parts.push_back(fmt::format("{}={}", problem.parameters[n].name, value_text(values[n])));
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string reached_text(const Objective& objective, std::size_t target) {
  const auto points = objective.points();
  const auto [least, greatest] = std::minmax_element(
      points.begin(), points.end(),
      [&](const auto& one, const auto& other) { return one.mean[target] < other.mean[target]; });
  const auto& problem = objective.problem();
  return fmt::format("{} reached from {:.4g} (at {}) to {:.4g} (at {})",
                     problem.targets[target].name, least->mean[target],
                     values_text(problem, least->values), greatest->mean[target],
                     values_text(problem, greatest->values));
}

SearchResult search(Objective& objective) {
  const auto& problem = objective.problem();
  return problem.parameters.size() == 1 && problem.targets.size() == 1 ? search_root(objective)
                                                                       : search_minimax(objective);
}

}  // namespace gasgrain
