// Study of the contact model: linear spring or Hertz, with and without the tangential history; each
// by our loop over contacts and by LIGGGHTS's own.
#include <fmt/format.h>

#include <algorithm>

#include "tools/study/bounce.h"
#include "tools/study/kinds.h"
#include "tools/study/pair_style.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

std::string name_of(const std::string& model, const std::string& style) {
  std::string name = style == own_pair_style ? model : model + " " + style;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string beside(const StudyRow& row, const StudyRow& other) {
  return fmt::format(
      "{:+.0f} % of wall time, bed height differs by {:.2g} %, kinetic energy by {:.2g} %",
      100.0 * (row.figures.get(study_cost) / other.figures.get(study_cost) - 1.0),
      100.0 * row.figures.get("height_error"), 100.0 * row.figures.get("energy_error"));
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    const bool by_host = row.point.pair_style == host_pair_style;
    const std::string& reference = row.point.reference;
    const StudyRow* other = row_of(rows, reference.empty() ? rows.front().point.name : reference);
    if (!row.ok() || other == nullptr || other == &row) continue;
    const std::string& model = row.point.dials[0].second;
    if (!reference.empty())
      lines.push_back(fmt::format("`{}` by pair_style {} in place of {}: {}.", model,
                                  host_pair_style, own_pair_style, beside(row, *other)));
    else
      lines.push_back(fmt::format("`{}`{}: {}.", model,
                                  by_host ? " (pair_style gran, as ours has no such loop)" : "",
                                  beside(row, *other)));
  }
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
  study.series = "pair_style";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from the first";
  study.reference_text =
      "the bed against that of the first model (another model is another physics, not an error), "
      "with pair_style gran against the same model's with gran/bridge; the bounce of one grain "
      "against a wall at 1 m/s against each model's own analytic solution";
  for (const auto& model : models)
    for (const char* style : {own_pair_style, host_pair_style}) {
      const bool both = own_loop_has(model);
      if (style == own_pair_style && !both) continue;
      StudyPoint point;
      point.name = name_of(model, style);
      point.dials = {{"contact", model}, {"pair_style", style}};
      point.variables = {{"contact", model}};
      point.pair_style = style;
      if (style == host_pair_style && both) point.reference = name_of(model, own_pair_style);
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
