// What the user asks of `gasgrain analyse`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gasgrain {

struct AnalyseOptions {
  std::filesystem::path results;  // a folder, or one file of dumps
  std::string dump;               // pattern of the dumps in it; empty: the only ones there
  std::string big = "largest";    // or "type=2", "id=1,7", "above=0.002" (diameter [m])
  std::string force;              // columns of the force; empty: f_mean[1..3], else fx fy fz
  double window_s = 2.5e-3;
  std::vector<double> sizes{1.0, 1.5, 2.0, 2.5};  // sides of the control volumes over d_s + d_b
  std::vector<double> steady_s;                   // from, to; empty: see steady_period
  // Empty: of analyse.toml of the results, the step also of run.json.
  std::optional<double> timestep_s;
  std::optional<double> restitution;
  std::optional<double> friction;
  std::optional<double> density;
  std::optional<double> density_big;  // empty: as density
  std::filesystem::path out;          // empty: the results folder
  bool no_plots = false;
  std::vector<std::string> unexpected;  // words of the command line that are no option
  std::vector<std::string> known;       // the options, for the nearest to them
};

}  // namespace gasgrain
