// Study of the contact model: linear spring or Hertz, with and without the tangential history; each
// by our loop over contacts and by LIGGGHTS's own.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tools/study/bounce.h"
#include "tools/study/kinds.h"
#include "tools/study/pair_style.h"
#include "tools/study/scene_material.h"
#include "tools/study/trace_error.h"

namespace gasgrain {
namespace {

std::string name_of(const std::string& model, const std::string& style) {
  std::string name = style == own_pair_style ? model : model + " " + style;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

const std::string& model_of(const StudyPoint& point) {
  return point.variables.front().second;
}

std::string beside(const StudyRow& row, const StudyRow& other, const char* height,
                   const char* energy) {
  return fmt::format(
      "{:+.0f} % of wall time, bed height differs by {:.2g} %, kinetic energy by {:.2g} %.",
      100.0 * (row.figures.get(study_cost) / other.figures.get(study_cost) - 1.0),
      100.0 * row.figures.get(height), 100.0 * row.figures.get(energy));
}

// How far the run in this folder is from the same run of the other point.
void add_loop_errors(const std::filesystem::path& folder, const std::string& other,
                     Figures& figures) {
  const auto history =
      folder.parent_path().parent_path() / other / folder.filename() / "history.csv";
  if (!std::filesystem::exists(history)) return;  // it failed
  Figures errors;
  add_trace_errors(folder / "history.csv", history, errors);
  for (const char* name : {"height_error", "energy_error"})
    figures.set(std::string("loop_") + name, errors.get(name));
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  const StudyRow& first = rows.front();
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    if (!row.ok() || &row == &first) continue;
    const std::string& model = model_of(row.point);
    const bool by_host = row.point.pair_style == host_pair_style;
    const StudyRow* ours = by_host ? row_of(rows, name_of(model, own_pair_style)) : nullptr;
    if (ours != nullptr)
      lines.push_back(fmt::format("`{}` by pair_style {} in place of {}: {}", model,
                                  host_pair_style, own_pair_style,
                                  beside(row, *ours, "loop_height_error", "loop_energy_error")));
    else if (first.ok())
      lines.push_back(fmt::format("`{}`{}: {}", model,
                                  by_host ? " (by pair_style gran, as ours has no such loop)" : "",
                                  beside(row, first, "height_error", "energy_error")));
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
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from the first";
  study.reference_text =
      "the bed against that of the first model (another model is another physics, not an error), "
      "loop_*: with pair_style gran against the same model's with gran/bridge; the bounce of one "
      "grain against a wall at 1 m/s against each model's own analytic solution";
  for (const auto& model : models)
    for (const char* style : {own_pair_style, host_pair_style}) {
      const bool both = own_loop_has(model);
      if (style == own_pair_style && !both) continue;
      StudyPoint point;
      point.name = name_of(model, style);
      point.dials = {{"contact", style == own_pair_style ? model : model + ", gran"},
                     {"pair_style", style}};
      point.variables = {{"contact", model}};
      point.pair_style = style;
      point.settle_s = 0.02;
      study.points.push_back(point);
    }
  study.add_figures = [material, step](const StudyPoint& point, const std::filesystem::path& folder,
                                       Figures& figures) {
    add_bounce_figures(material, model_of(point), step, folder / "bounce", figures);
    if (point.pair_style == host_pair_style && own_loop_has(model_of(point)))
      add_loop_errors(folder, name_of(model_of(point), own_pair_style), figures);
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
