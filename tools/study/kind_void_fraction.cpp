// Study of the void-fraction methods over the size of the cells (Alobaid 2013, 8.1.2 and 8.1.3).
#include <algorithm>

#include "coupling/base/error.h"
#include "coupling/exchange/void_fraction/read_method.h"
#include "tools/study/gas_cells.h"
#include "tools/study/kinds.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

constexpr const char* exact_method = "exact";

std::vector<std::string> methods_of(const StudyOptions& options) {
  auto known = method_names();
  std::vector<std::string> methods = options.values;
  if (methods.empty()) {
    methods = known;
    methods.erase(std::remove(methods.begin(), methods.end(), "auto"), methods.end());
  }
  for (const auto& method : methods) {
    const std::string name = method.substr(0, method.find(' '));
    if (std::find(known.begin(), known.end(), name) == known.end())
      fail("--values \"{}\": this void-fraction method is unknown.{}", method,
           suggestion(name, known));
  }
  methods.erase(std::remove(methods.begin(), methods.end(), exact_method), methods.end());
  methods.insert(methods.begin(), exact_method);
  return methods;
}

// Over the methods at cells of `least` to `most` diameters, of the errors of `figure`; the
// greatest.
double worst(const std::vector<StudyRow>& rows, const std::string& method, double least,
             double most) {
  double error = std::nan("");
  for (const auto& row : rows) {
    const double size = row.figures.get("cell_over_diameter");
    if (row.ok() && row.point.dials[1].second == method && size >= least && size < most)
      error = std::fmax(error, row.figures.get("energy_error"));
  }
  return error;
}

// Of offset over centre, at the cells of a diameter and more where it is greatest.
double greatest_gain(const std::vector<StudyRow>& rows) {
  double gain = std::nan("");
  for (const auto& row : rows) {
    const double size = row.figures.get("cell_over_diameter");
    if (!row.ok() || size < 1.0) continue;
    gain = std::fmax(gain, worst(rows, "centre", size, std::nextafter(size, 1e9)) /
                               worst(rows, "offset", size, std::nextafter(size, 1e9)));
  }
  return gain;
}

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  std::vector<std::string> lines;
  for (const auto& [from, to] : {std::pair(0.0, 1.0), std::pair(1.0, 2.0), std::pair(2.0, 1e9)}) {
    std::string line;
    for (const char* method : {"centre", "offset", "trilinear", "kernel", "particle_grid"})
      if (const double error = worst(rows, method, from, to); std::isfinite(error))
        line += fmt::format("{}{} {:.1f} %", line.empty() ? "" : ", ", method, 100.0 * error);
    if (!line.empty())
      lines.push_back(fmt::format("Kinetic energy against `exact` with cells of {}: {}.",
                                  from == 0.0   ? "less than 1 d"
                                  : from == 1.0 ? "1 to 2 d"
                                                : "2 d and more",
                                  line));
  }
  const double gain = greatest_gain(rows);
  if (std::isfinite(gain))
    lines.push_back(fmt::format(
        "offset is up to {:.0f} times as accurate as centre with cells of 1 d and more. Alobaid "
        "(2013), 8.1.2: up to ten times; {}.",
        gain, gain >= 5.0 ? "agreement" : "disagreement"));
  double share = 0.0;
  for (const auto& row : rows)
    if (row.ok()) share = std::fmax(share, row.figures.get("void_fraction_share"));
  lines.push_back(
      fmt::format("The dearest method takes {:.1f} % of the wall time.", 100.0 * share));
  return lines;
}

}  // namespace

Study plan_void_fraction(const SceneCopy& scene, const StudyOptions& options) {
  static_cast<void>(scene.variable("void_fraction"));
  const GasCells own(scene);
  const double diameter = 2.0 * scene_material(options.scene).radius;
  Study study;
  study.dial = "cell_over_diameter";
  study.dial_text = "cell size over grain diameter";
  study.series = "method";
  study.error = "energy_error";
  study.error_text = "kinetic energy, rms difference from exact";
  study.reference_text =
      "the run with the exact share of each sphere in each cell, on the same cells; what the cells "
      "themselves change is `study grid`. clamps: how often a limiter acted";
  const std::vector<double> factors =
      options.quick ? std::vector<double>{1.0, 2.0} : std::vector<double>{0.5, 0.75, 1.0, 1.5, 2.0};
  for (const double factor : factors) {
    const GasCells grid = own.times(factor);
    for (const auto& method : methods_of(options)) {
      std::string plain = method;
      std::replace(plain.begin(), plain.end(), ' ', '_');
      StudyPoint point;
      point.name = fmt::format("{}_x{}", plain, text_of(factor));
      point.reference = fmt::format("{}_x{}", exact_method, text_of(factor));
      point.dials = {{"cell_over_diameter", fmt::format("{:.3g}", grid.cell_size() / diameter)},
                     {"method", method}};
      point.variables = {{"void_fraction", method}};
      point.gas_keys = {{"grid.cells", grid.text()}};
      study.points.push_back(point);
    }
  }
  study.add_figures = [](const StudyPoint& point, const std::filesystem::path&, Figures& figures) {
    figures.set("cell_over_diameter", std::stod(point.dials[0].second));
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
