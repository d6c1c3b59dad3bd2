#include "tools/calibrate/calibrate_report.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "coupling/base/error.h"
#include "tools/whole_file.h"

namespace gasgrain {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string set_options(const CalibrationProblem& problem, const CalibrationPoint& point) {
  std::string text;
  for (std::size_t n = 0; n < point.values.size(); ++n)
    text += fmt::format(" --set {}={}", problem.parameters[n].name, value_text(point.values[n]));
  return text;
}

std::string script_lines(const CalibrationProblem& problem, const Calibration& result) {
  std::string text;
  for (std::size_t n = 0; n < problem.parameters.size(); ++n) {
    text += fmt::format("variable {} index {}", problem.parameters[n].name,
                        value_text(result.point.values[n]));
    if (result.point.repeats > 1) text += fmt::format("   # +- {:.2g}", result.uncertainty[n]);
    text += "\n";
  }
  return text;
}

}  // namespace

void write_runs(const fs::path& folder, const CalibrationProblem& problem,
                const std::vector<CalibrationRun>& runs) {
  std::string text = "run,point";
  for (const auto& parameter : problem.parameters) text += "," + parameter.name;
  text += ",seed";
  for (const auto& target : problem.targets) text += "," + target.name;
  text += ",wall_s\n";
  int number = 0;
  for (const auto& run : runs) {
    text += fmt::format("{},{}", ++number, run.point);
    for (const double value : run.request.values) text += "," + value_text(value);
    text += problem.has_seed ? fmt::format(",{}", run.request.seed) : std::string(",");
    for (const double value : run.outcome.measured) text += fmt::format(",{:.6g}", value);
    text += fmt::format(",{:.2f}\n", run.outcome.wall_s);
  }
  write_whole(folder / "calibration.csv", text);
}

void write_result(const fs::path& folder, const std::string& command, const fs::path& scene,
                  const Objective& objective, const Calibration& result) {
  const auto& problem = objective.problem();
  json parameters = json::array();
  for (std::size_t n = 0; n < problem.parameters.size(); ++n) {
    const auto& parameter = problem.parameters[n];
    json entry{{"name", parameter.name},
               {"low", parameter.low},
               {"high", parameter.high},
               {"value", result.point.values[n]}};
    if (result.met && result.point.repeats > 1) entry["standard_error"] = result.uncertainty[n];
    if (result.met) entry["allowed_by_tolerance"] = result.allowed[n];
    parameters.push_back(entry);
  }
  json targets = json::array();
  for (std::size_t n = 0; n < problem.targets.size(); ++n) {
    const auto& target = problem.targets[n];
    targets.push_back({{"name", target.name},
                       {"value", target.value},
                       {"tolerance", target.tolerance},
                       {"mean", result.point.mean[n]},
                       {"standard_error", result.point.standard_error[n]},
                       {"repeats", result.point.repeats},
                       {"scatter", objective.scatter(n)}});
    if (!result.slopes.empty()) targets.back()["slopes"] = result.slopes[n];
  }
  constexpr int indent = 2;
  write_whole(folder / "calibration.json", json{{"command", command},
                                                {"met", result.met},
                                                {"parameters", parameters},
                                                {"targets", targets}}
                                                   .dump(indent) +
                                               "\n");
  if (!result.met) return;
  write_whole(
      folder / "calibrated.txt",
      fmt::format("# {}\n{}\n# or\n#   gasgrain run {}{}\n", command, script_lines(problem, result),
                  scene.string(), set_options(problem, result.point)));
}

}  // namespace gasgrain
