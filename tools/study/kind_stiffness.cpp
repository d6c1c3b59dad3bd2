// Study of the contacts' stiffness (Alobaid 2013, 8.1.5.1): softer grains allow longer DEM steps
#include <fmt/format.h>

#include <algorithm>

// and overlap more.
#include "tools/study/bounce.h"
#include "tools/study/kinds.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

// The contact time falls as E^-0.4, at any speed, for Hertz's contact and LIGGGHTS's hooke alike.
constexpr double step_exponent = -0.4;

// Alobaid (2013), 8.1.5.1 and chapter 9 [N/m].
constexpr double thesis_softest = 5e4;
constexpr double thesis_stiffest = 5e6;

std::string without_bed_findings(const std::vector<StudyRow>& rows) {
  constexpr double enough = 0.02;
  double softest = std::nan("");
  for (const auto& row : rows)
    if (row.ok() && row.figures.get("height_error") <= enough)
      softest = std::fmin(softest, row.figures.get("linear_stiffness_N_m"));
  if (std::isnan(softest))
    return "No softer contact kept the bed height within 2 % of the stiffest's.";
  const bool disagrees = softest < thesis_softest / 2.0;
  return fmt::format(
      "Bed height within 2 % of the stiffest's from {:.2g} N/m on. Alobaid (2013) recommends 5e4 "
      "to "
      "5e6 N/m: {}.",
      softest,
      disagrees ? "disagreement, softer contacts do here. His range rests on overlaps of a radius "
                  "at 2 to 10 m/s in his table 8.3, which his own eq. 7.20 puts at some 50 to 1300 "
                  "N/m for these grains"
                : "agreement");
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  std::vector<std::string> lines{fmt::format(
      "Wall time goes as k^{:.2f}, k the linear stiffness. Alobaid (2013), eq. 8.6: k^0.5, where "
      "the DEM steps are nearly all of the time.",
      exponent(rows, study_cost, "linear_stiffness_N_m"))};
  lines.push_back(without_bed_findings(rows));
  lines.push_back(fmt::format("Greatest overlap goes as k^{:.2f} (a spring's: k^-0.5).",
                              exponent(rows, "overlap", "linear_stiffness_N_m")));
  return lines;
}

}  // namespace

Study plan_stiffness(const SceneCopy& scene, const StudyOptions& options) {
  const double youngs = number_of(scene, "youngs");
  const double step = number_of(scene, "dt");
  const double interval = number_of(scene, "interval");
  const std::string contact = scene.variable("contact");
  const GrainMaterial material = scene_material(options.scene);
  // LIGGGHTS asks for at least 5e6 Pa and, without `hard_particles`, at most 1e9 Pa.
  auto values =
      values_or(options, options.quick ? std::vector<double>{5e6, 1e7, 3e7, 1e8}
                                       : std::vector<double>{5e6, 1e7, 3e7, 1e8, 3e8, 1e9});
  // The reference is the stiffest.
  std::rotate(values.begin(), values.end() - 1, values.end());
  Study study;
  study.dial = "linear_stiffness_N_m";
  study.dial_text = "linear stiffness at 1 m/s [N/m]";
  study.error = "height_error";
  study.error_text = "bed height, rms difference from stiffest";
  study.reference_text =
      "the bed against that of the stiffest grains, which all begin from; the bounce of one grain "
      "against a wall at 1 "
      "m/s "
      "against its analytic solution, greatest of eight phases of a step";
  for (const double value : values) {
    GrainMaterial changed = material;
    changed.youngs = value;
    const double own = dividing_step(interval, step * std::pow(value / youngs, step_exponent));
    StudyPoint point;
    point.name = "E_" + text_of(value);
    point.dials = {{"youngs_Pa", text_of(value)},
                   {"linear_stiffness_N_m", text_of(linear_stiffness(changed, study_impact_speed))},
                   {"dt_s", text_of(own)}};
    point.variables = {{"youngs", text_of(value)}, {"dt", fmt::format("{:.12g}", own)}};
    // Packed stiff, the bed sinks into its new overlaps; packed soft, it would leap.
    point.settle_s = 0.02;
    point.expected_cost = step / own;
    study.points.push_back(point);
  }
  study.packing = study.points.front().variables;
  study.add_figures = [material, contact](const StudyPoint& point,
                                          const std::filesystem::path& folder, Figures& figures) {
    GrainMaterial own = material;
    own.youngs = std::stod(point.dials[0].second);
    figures.set("linear_stiffness_N_m", std::stod(point.dials[1].second));
    add_bounce_figures(own, contact, std::stod(point.dials[2].second), folder / "bounce", figures);
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
