#include "tools/calibrate/calibrate_text.h"

#include <fmt/ranges.h>

#include <cmath>

namespace gasgrain {

namespace {

std::string measured_text(const CalibrationProblem& problem, const CalibrationPoint& point) {
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < point.mean.size(); ++n) {
    const auto& target = problem.targets[n];
    std::string text = fmt::format("{} {:.4g}", target.name, point.mean[n]);
    if (point.repeats > 1) text += fmt::format(" +- {:.2g}", point.standard_error[n]);
    parts.push_back(text + fmt::format(" (target {:g} +- {:.2g})", target.value, target.tolerance));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Why the targets are not met, and what may help.
std::string not_met_text(const Objective& objective, const Calibration& result) {
  const auto& problem = objective.problem();
  std::string text;
  if (!result.out_of_reach.empty()) {
    text = result.out_of_reach;
  } else {
    text = "The targets are not met together within their tolerances.";
    for (std::size_t n = 0; n < problem.targets.size(); ++n)
      text += "\n" + reached_text(objective, n) + ".";
  }
  for (std::size_t n = 0; n < problem.parameters.size(); ++n) {
    const auto& parameter = problem.parameters[n];
    const double value = result.point.values[n];
    if (value == parameter.low || value == parameter.high)
      text += fmt::format("\nThe nearest is at an end of the range of {}: widen --vary {}.",
                          parameter.name, parameter.name);
  }
  for (std::size_t n = 0; n < problem.targets.size(); ++n) {
    const double scatter = objective.scatter(n);
    const auto repeats = static_cast<double>(problem.seeds.size());
    // A mean that strays by more than half the tolerance misses it one time in twenty.
    if (result.out_of_reach.empty() &&
        scatter / std::sqrt(repeats) > 0.5 * problem.targets[n].tolerance)
      text += fmt::format(
          "\nA run scatters by {:.2g} in {}, the mean of {} by {:.2g}: ask for more --seeds or a "
          "wider --tolerance.",
          scatter, problem.targets[n].name, repeats, scatter / std::sqrt(repeats));
  }
  return text;
}

}  // namespace

std::string point_text(const CalibrationProblem& problem, int number,
                       const CalibrationPoint& point) {
  return fmt::format("point {}  {}: {}, {} {}", number, values_text(problem, point.values),
                     measured_text(problem, point), point.repeats,
                     point.repeats == 1 ? "run" : "runs");
}

std::string result_text(const Objective& objective, const Calibration& result) {
  const auto& problem = objective.problem();
  if (!result.met)
    return fmt::format("{}\nThe nearest: {}: {}\n", not_met_text(objective, result),
                       values_text(problem, result.point.values),
                       measured_text(problem, result.point));
  std::string text;
  for (std::size_t n = 0; n < problem.parameters.size(); ++n) {
    text += fmt::format("{} = {}", problem.parameters[n].name, value_text(result.point.values[n]));
    if (result.point.repeats > 1)
      text += fmt::format(" +- {:.2g} (standard error, {} seeds)", result.uncertainty[n],
                          result.point.repeats);
    text += fmt::format("; the tolerance allows +- {:.2g}\n", result.allowed[n]);
  }
  return text + fmt::format("There: {}\n", measured_text(problem, result.point));
}

}  // namespace gasgrain
