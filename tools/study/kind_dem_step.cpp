// Study of the DEM step: how many steps a contact needs.
#include "coupling/base/error.h"
#include "tools/study/bounce.h"
#include "tools/study/kinds.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  constexpr double enough = 0.01;
  double longest = std::nan("");
  for (const auto& row : rows)
    if (row.ok() && row.figures.get("restitution_error") <= enough)
      longest = std::fmax(longest, row.figures.get("step_over_contact_time"));
  std::vector<std::string> lines{
      fmt::format("The error of the restitution goes as the step to the power {:.1f}.",
                  exponent(rows, "restitution_error", "step_over_contact_time"))};
  lines.push_back(std::isnan(longest)
                      ? std::string("No step kept the restitution within 1 %.")
                      : fmt::format("Restitution within 1 % up to {:.3g} of the contact time. "
                                    "Usual advice, for grains in many contacts at once: 1/50 to "
                                    "1/20 of it.",
                                    longest));
  return lines;
}

}  // namespace

Study plan_dem_step(const SceneCopy& scene, const StudyOptions& options) {
  const double interval = number_of(scene, "interval");
  const std::string contact = scene.variable("contact");
  const GrainMaterial material = scene_material(options.scene);
  const auto duration = contact_duration(material, contact, study_impact_speed);
  if (!duration)
    fail("{}: the contact time of `{}` is not known to this study: it knows hertz and hooke.",
         scene.script_path(), contact);
  Study study;
  study.dial = "step_over_contact_time";
  study.dial_text = "DEM step over contact time at 1 m/s";
  study.error = "restitution_error";
  study.error_text = "restitution of a bounce, relative error";
  study.error_is_of_the_bed = false;
  study.reference_text =
      "the bounce of one grain against its analytic solution (restitution_error, "
      "contact_time_error) and, without damping, of its energy (energy_drift); the bed against "
      "that "
      "of the shortest step";
  const auto shares =
      values_or(options, options.quick ? std::vector<double>{0.01, 0.02, 0.04, 0.08, 0.16}
                                       : std::vector<double>{0.005, 0.01, 0.02, 0.04, 0.08, 0.16});
  for (const double share : shares) {
    const double step = dividing_step(interval, share * *duration);
    StudyPoint point;
    point.name = "step_" + text_of(share);
    point.dials = {{"step_over_contact_time", text_of(step / *duration)}, {"dt_s", text_of(step)}};
    point.variables = {{"dt", fmt::format("{:.12g}", step)}};
    point.expected_cost = 0.04 / share;
    study.points.push_back(point);
  }
  study.add_figures = [material, contact](const StudyPoint& point,
                                          const std::filesystem::path& folder, Figures& figures) {
    figures.set("step_over_contact_time", std::stod(point.dials[0].second));
    add_bounce_figures(material, contact, std::stod(point.variables[0].second), folder / "bounce",
                       figures);
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
