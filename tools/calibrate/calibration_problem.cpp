#include "tools/calibrate/calibration_problem.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include "coupling/base/error.h"
#include "tools/calibrate/objective.h"
#include "tools/calibrate/repeat_seeds.h"
#include "tools/calibrate/scene_dials.h"

namespace gasgrain {
namespace {

using Faults = std::vector<std::string>;

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return {};
  return value;
}

// The parts before and after the first '='.
std::pair<std::string, std::string> split(const std::string& text, char at = '=') {
  const auto place = text.find(at);
  if (place == std::string::npos) return {text, ""};
  return {text.substr(0, place), text.substr(place + 1)};
}

std::vector<CalibrationTarget> targets(const CalibrateOptions& options, Faults& faults) {
  std::vector<CalibrationTarget> result;
  for (const auto& text : options.targets) {
    const auto [name, value] = split(text);
    const auto met = number(value);
    if (name.empty() || !met)
      faults.push_back(
          fmt::format("--target {}: write it as NAME=VALUE, for example angle_of_repose=28", text));
    else if (std::any_of(result.begin(), result.end(),
                         [&name = name](const auto& other) { return other.name == name; }))
      faults.push_back(fmt::format("--target {}: {} is given twice.", text, name));
    else
      result.push_back({name, *met, usual_tolerance * std::abs(*met)});
  }
  return result;
}

void set_tolerances(const CalibrateOptions& options, std::vector<CalibrationTarget>& targets,
                    Faults& faults) {
  std::vector<std::string> names;
  for (const auto& target : targets) names.push_back(target.name);
  for (const auto& text : options.tolerances) {
    const bool for_all = text.find('=') == std::string::npos;
    const auto [name, value] = for_all ? std::make_pair(std::string(), text) : split(text);
    const auto tolerance = number(value);
    if (!tolerance || *tolerance <= 0.0)
      faults.push_back(fmt::format(
          "--tolerance {}: write it as NAME=VALUE or VALUE, above 0, in the target's unit", text));
    else if (!for_all && std::find(names.begin(), names.end(), name) == names.end())
      faults.push_back(
          fmt::format("--tolerance {}: there is no such target.{}", text, suggestion(name, names)));
    else
      for (auto& target : targets)
        if (for_all || target.name == name) target.tolerance = *tolerance;
  }
  for (const auto& target : targets)
    if (target.tolerance == 0.0)
      faults.push_back(
          fmt::format("--target {0}=0: no tolerance can be taken as a share of 0. Give one: "
                      "--tolerance {0}=VALUE",
                      target.name));
}

// Variables that `gasgrain run`, --seeds and --quick set.
bool is_taken(const std::string& name) {
  const std::vector<std::string> taken{"out", "time", "restart", "seed", "quick"};
  return std::find(taken.begin(), taken.end(), name) != taken.end();
}

// The variables of the script that a calibration may turn.
std::vector<std::string> free_names(const std::map<std::string, std::string>& dials) {
  std::vector<std::string> names;
  for (const auto& dial : dials)
    if (!is_taken(dial.first)) names.push_back(dial.first);
  return names;
}

std::vector<CalibrationParameter> parameters(const CalibrateOptions& options,
                                             const std::vector<std::string>& names,
                                             Faults& faults) {
  std::vector<CalibrationParameter> result;
  for (const auto& text : options.varied) {
    const auto [name, range] = split(text);
    const auto [low_text, high_text] = split(range, ':');
    const auto low = number(low_text);
    const auto high = number(high_text);
    if (name.empty() || !low || !high) {
      faults.push_back(
          fmt::format("--vary {}: write it as NAME=LOW:HIGH, for example friction=0.1:0.8", text));
      continue;
    }
    if (as_written(*low) >= as_written(*high))
      faults.push_back(fmt::format("--vary {}: the lower end must be below the upper: {}={}:{}",
                                   text, name, value_text(std::min(*low, *high)),
                                   *low == *high ? "HIGH" : value_text(std::max(*low, *high))));
    if (is_taken(name))
      faults.push_back(fmt::format("--vary {}: this variable is set by gasgrain itself.{}", text,
                                   suggestion("", names)));
    else if (std::find(names.begin(), names.end(), name) == names.end())
      faults.push_back(
          fmt::format("--vary {}: {} has no line 'variable {} index VALUE' to be set.{}", text,
                      (options.scene / "in.liggghts").string(), name, suggestion(name, names)));
    if (std::any_of(result.begin(), result.end(),
                    [&name = name](const auto& other) { return other.name == name; }))
      faults.push_back(fmt::format("--vary {}: {} is given twice.", text, name));
    result.push_back({name, as_written(*low), as_written(*high)});
  }
  return result;
}

void set_seeds(const CalibrateOptions& options, const std::map<std::string, std::string>& dials,
               CalibrationProblem& problem, Faults& faults) {
  constexpr int usual_repeats = 3;
  const auto seed = dials.find("seed");
  problem.has_seed = seed != dials.end();
  problem.seeds = {0};
  if (!problem.has_seed && options.seeds.value_or(1) > 1)
    faults.push_back(
        fmt::format("--seeds {}: {} has no line 'variable seed index VALUE': all its runs are "
                    "alike. Leave out --seeds.",
                    *options.seeds, (options.scene / "in.liggghts").string()));
  if (!problem.has_seed) return;
  const auto first = number(seed->second);
  if (!first || *first < 1 || *first > 1e8 || *first != std::floor(*first))
    faults.push_back(
        fmt::format("{}: variable seed index {}: a seed is a whole number from 1 to 1e8.",
                    (options.scene / "in.liggghts").string(), seed->second));
  else
    problem.seeds = repeat_seeds(static_cast<long>(*first), options.seeds.value_or(usual_repeats));
}

}  // namespace

CalibrationProblem calibration_problem(const CalibrateOptions& options, Faults faults) {
  CalibrationProblem problem;
  problem.targets = targets(options, faults);
  set_tolerances(options, problem.targets, faults);
  const auto dials = scene_dials(options.scene);
  problem.parameters = parameters(options, free_names(dials), faults);
  set_seeds(options, dials, problem, faults);
  problem.search_repeats = std::min(options.jobs, static_cast<int>(problem.seeds.size()));
  if (options.varied.size() > options.targets.size())
    faults.push_back(fmt::format(
        "{} parameters cannot be told from {} measured: add a --target, or leave out a --vary.",
        options.varied.size(), options.targets.size()));
  if (options.quick && dials.count("quick") == 0)
    faults.push_back(
        fmt::format("--quick: {} has no line 'variable quick index 0': the scene has "
                    "no quick preset. Leave out --quick.",
                    (options.scene / "in.liggghts").string()));
  if (!std::filesystem::is_regular_file(options.scene / "measure.toml"))
    faults.push_back(
        fmt::format("{} is absent: the scene measures nothing. Scenes that do are in "
                    "inputs/calibration.",
                    (options.scene / "measure.toml").string()));
  if (!faults.empty())
    fail("{} cannot be calibrated:\n  {}", options.scene.string(), fmt::join(faults, "\n  "));
  return problem;
}

}  // namespace gasgrain
