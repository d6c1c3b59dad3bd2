// What the user asks of `gasgrain run`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/dem_host.h"

namespace gasgrain {

struct RunOptions {
  std::filesystem::path scene;
  DemHost host = DemHost::liggghts;
  int dem_ranks = 2;
  int gas_ranks = 1;
  bool dem_ranks_given = false;  // by the user; a scene of grains alone else has one
  bool gas_ranks_given = false;
  std::optional<double> time_s;        // simulated time; the scene's own when absent
  std::filesystem::path out;           // empty: results/<scene name>
  std::string gas_input = "gas.toml";  // in the scene's folder
  bool restart = false;
  bool no_plots = false;
  std::vector<std::pair<std::string, std::string>> variables;  // handed to the DEM script
};

}  // namespace gasgrain
