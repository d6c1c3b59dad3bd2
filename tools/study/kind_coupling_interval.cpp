// Study of the coupling interval, with grains that wait for the gas and grains that do not.
#include <fmt/format.h>

#include "tools/study/kinds.h"

namespace gasgrain {
namespace {

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  std::vector<std::string> lines;
  for (const char* mode : {"in_turn", "overlapped"}) {
    double longest = 0.0;
    for (const auto& row : rows)
      if (row.ok() && row.point.dials[1].second == mode && row.figures.get("energy_error") <= 0.05)
        longest = std::fmax(longest, row.figures.get("interval_s"));
    lines.push_back(longest > 0.0
                        ? fmt::format("{}: kinetic energy within 5 % of the shortest interval's up "
                                      "to {:.3g} ms.",
                                      mode, 1e3 * longest)
                        : fmt::format("{}: no interval beside the reference's kept the kinetic "
                                      "energy within 5 %.",
                                      mode));
  }
  return lines;
}

}  // namespace

Study plan_coupling_interval(const SceneCopy& scene, const StudyOptions& options) {
  const double dt = number_of(scene, "dt");
  static_cast<void>(scene.variable("mode"));
  Study study;
  study.dial = "interval_s";
  study.dial_text = "coupling interval [s]";
  study.series = "mode";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from shortest";
  study.reference_text = "the run with the shortest interval, in turn";
  const auto intervals =
      values_or(options, options.quick ? std::vector<double>{2e-4, 1e-3, 2e-3, 5e-3}
                                       : std::vector<double>{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3});
  for (const double interval : intervals)
    for (const char* mode : {"in_turn", "overlapped"}) {
      StudyPoint point;
      point.name = fmt::format("{}_{}", mode, text_of(interval));
      point.dials = {{"interval_s", text_of(interval)}, {"mode", mode}};
      point.variables = {{"interval", text_of(interval)},
                         {"mode", mode},
                         {"dt", fmt::format("{:.12g}", dividing_step(interval, dt))}};
      study.points.push_back(point);
    }
  study.add_figures = [](const StudyPoint& point, const std::filesystem::path&, Figures& figures) {
    figures.set("interval_s", std::stod(point.dials[0].second));
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
