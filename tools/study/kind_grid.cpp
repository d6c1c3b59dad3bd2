// Study of the fluid cells against the particle grid (Alobaid 2013, 8.1.3).
#include <fmt/format.h>

#include <algorithm>

#include "tools/study/gas_cells.h"
#include "tools/study/kinds.h"
#include "tools/study/scene_material.h"

namespace gasgrain {
namespace {

// Alobaid (2013), 8.1.3 and chapter 9: fluid cells a particle cell.
constexpr double thesis_fewest = 4.0;
constexpr double thesis_most = 10.0;

std::vector<std::string> findings(const std::vector<StudyRow>& rows, double) {
  const StudyRow* best = nullptr;
  for (const auto& row : rows)
    if (row.on_front && std::isfinite(row.figures.get("fluid_cells_a_particle_cell")) &&
        (best == nullptr || row.figures.get("height_error") < best->figures.get("height_error")))
      best = &row;
  if (best == nullptr) return {"No point with a particle grid is on the Pareto front."};
  const double ratio = best->figures.get("fluid_cells_a_particle_cell");
  const bool within = ratio >= thesis_fewest && ratio <= thesis_most;
  return {fmt::format(
      "The most accurate point of the front with a particle grid, {}, has {:.1f} fluid cells a "
      "particle cell. Alobaid (2013) recommends particle cells of 2 to 3 d and 4 to 10 fluid cells "
      "in each: {}.",
      best->point.name, ratio, within ? "agreement" : "disagreement")};
}

}  // namespace

Study plan_grid(const SceneCopy& scene, const StudyOptions& options) {
  const std::string usual = scene.variable("void_fraction");
  const GasCells own(scene);
  const double diameter = 2.0 * scene_material(options.scene).radius;
  auto factors = values_or(options, options.quick ? std::vector<double>{0.5, 1.0, 2.0}
                                                  : std::vector<double>{0.5, 0.75, 1.0, 1.5, 2.0});
  Study study;
  study.dial = "cell_over_diameter";
  study.dial_text = "fluid cell size over grain diameter";
  study.series = "method";
  study.error = "height_error";
  study.error_text = "bed height, rms difference from the finest";
  study.reference_text = "the finest fluid cells with a particle grid of 2 d";
  // The finest first: they are the reference.
  std::reverse(factors.begin(), factors.end());
  for (const double factor : factors) {
    const GasCells grid = own.times(factor);
    const double by_diameter = grid.cell_size() / diameter;
    for (const std::string& method :
         {std::string("particle_grid 2"), std::string("particle_grid 3"), usual}) {
      StudyPoint point;
      const bool has_grid = method.rfind("particle_grid", 0) == 0;
      point.name =
          fmt::format("x{}_{}", text_of(factor), has_grid ? "grid_" + method.substr(14) : method);
      point.dials = {{"cell_over_diameter", fmt::format("{:.3g}", by_diameter)},
                     {"method", method},
                     {"fluid_cells", text_of(grid.count())}};
      if (has_grid)
        point.dials.emplace_back(
            "fluid_cells_a_particle_cell",
            fmt::format("{:.3g}", std::pow(std::stod(method.substr(14)) / by_diameter, 3)));
      point.variables = {{"void_fraction", method}};
      point.gas_keys = {{"grid.cells", grid.text()}};
      point.expected_cost = 1.0 + 0.3 * factor * factor * factor;
      study.points.push_back(point);
    }
  }
  study.add_figures = [](const StudyPoint& point, const std::filesystem::path&, Figures& figures) {
    constexpr std::size_t ratio = 3;  // of the dials
    if (point.dials.size() > ratio)
      figures.set("fluid_cells_a_particle_cell", std::stod(point.dials[ratio].second));
  };
  study.findings = findings;
  return study;
}

}  // namespace gasgrain
