// Study of the gas's greatest step (Alobaid 2013, 8.1.5.2).
#include <fmt/format.h>

#include <algorithm>

#include "tools/study/kinds.h"

namespace gasgrain {
namespace {

// Alobaid (2013), 8.1.5.2 and chapter 9 [s].
constexpr double thesis_shortest = 1e-3;
constexpr double thesis_longest = 5e-3;

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double chance) {
  const StudyRow* best = nullptr;
  double within = 0.0;
  for (const auto& row : rows) {
    if (!row.ok()) continue;
    if (best == nullptr || row.figures.get(study_cost) < best->figures.get(study_cost)) best = &row;
    if (row.figures.get("energy_error") <= std::fmax(0.05, 2.0 * chance))
      within = std::fmax(within, row.figures.get("fluid_step_s"));
  }
  std::vector<std::string> lines;
  if (best != nullptr)
    lines.push_back(fmt::format("Cheapest: a fluid step of {:.3g} ms.",
                                1e3 * best->figures.get("fluid_step_s")));
  lines.push_back(
      fmt::format("Kinetic energy within 5 % (or twice the chance difference) of the shortest "
                  "step's up to {:.3g} "
                  "ms. Alobaid (2013) recommends 1 to 5 ms: {}.",
                  1e3 * within,
                  within >= thesis_shortest && within <= thesis_longest ? "agreement"
                  : within > thesis_longest                             ? "longer steps do here"
                                            : "disagreement, this bed wants shorter ones"));
  return lines;
}

}  // namespace

Study plan_fluid_step(const SceneCopy& scene, const StudyOptions& options) {
  const double interval = number_of(scene, "interval");
  const double dt = number_of(scene, "dt");
  Study study;
  study.dial = "fluid_step_s";
  study.dial_text = "fluid step, at most [s]";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from shortest";
  study.reference_text =
      "the run with the shortest step. The coupling interval is the scene's, or the fluid step "
      "where "
      "that is longer; the Courant number may divide the step (gas_substeps)";
  const auto steps = values_or(
      options, options.quick ? std::vector<double>{1.25e-4, 5e-4, 1e-3, 2e-3, 5e-3}
                             : std::vector<double>{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2});
  for (const double step : steps) {
    const double own_interval = std::max(interval, step);
    const double own_dt = dividing_step(own_interval, dt);
    StudyPoint point;
    point.name = "step_" + text_of(step);
    point.dials = {{"fluid_step_s", text_of(step)}, {"interval_s", text_of(own_interval)}};
    point.variables = {{"interval", text_of(own_interval)}, {"dt", fmt::format("{:.12g}", own_dt)}};
    point.gas_keys = {{"time.step", text_of(step)}};
    study.points.push_back(point);
  }
  study.add_figures = [](const StudyPoint& point, const std::filesystem::path&, Figures& figures) {
    figures.set("fluid_step_s", std::stod(point.dials[0].second));
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
