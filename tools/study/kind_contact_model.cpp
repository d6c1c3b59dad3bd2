// Study of the contact model: linear spring or Hertz, with and without the tangential history.
#include <fmt/format.h>

#include <algorithm>

#include "tools/study/bounce.h"
#include "tools/study/kinds.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  const StudyRow& first = rows.front();
  std::vector<std::string> lines;
  for (const auto& row : rows)
    if (row.ok() && first.ok() && &row != &first)
      lines.push_back(fmt::format(
          "`{}`: {:+.0f} % of wall time, bed height differs by {:.2g} %, kinetic energy by {:.2g} "
          "%.",
          row.point.dials[0].second,
          100.0 * (row.figures.get(study_cost) / first.figures.get(study_cost) - 1.0),
          100.0 * row.figures.get("height_error"), 100.0 * row.figures.get("energy_error")));
  lines.emplace_back(
      "Alobaid (2013), 5.1.2.2.1: the linear spring is accurate enough in most cases, non-linear "
      "ones cost more.");
  return lines;
}

}  // namespace

Study plan_contact_model(const SceneCopy& scene, const StudyOptions& options) {
  const double step = number_of(scene, "dt");
  static_cast<void>(scene.variable("contact"));
  const GrainMaterial material = scene_material(options.scene);
  const auto models = options.values.empty()
                          ? std::vector<std::string>{"hertz tangential history",
                                                     "hertz tangential no_history",
                                                     "hertz",
                                                     "hooke tangential history",
                                                     "hooke tangential no_history",
                                                     "hooke"}
                          : options.values;
  Study study;
  study.dial = "contact";
  study.dial_text = "contact model";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from the first";
  study.reference_text =
      "the bed against that of the first model (another model is another physics, not an error); "
      "the "
      "bounce of one grain against a wall at 1 m/s against each model's own analytic solution";
  for (const auto& model : models) {
    StudyPoint point;
    point.name = model;
    std::replace(point.name.begin(), point.name.end(), ' ', '_');
    point.dials = {{"contact", model}};
    point.variables = {{"contact", model}};
    point.settle_s = 0.02;
    study.points.push_back(point);
  }
  study.add_figures = [material, step](const StudyPoint& point, const std::filesystem::path& folder,
                                       Figures& figures) {
    add_bounce_figures(material, point.dials[0].second, step, folder / "bounce", figures);
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
