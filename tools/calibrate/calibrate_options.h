// What the user asks of `gasgrain calibrate`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gasgrain {

struct CalibrateOptions {
  std::filesystem::path scene;
  std::vector<std::string> targets;     // "angle_of_repose=28"
  std::vector<std::string> varied;      // "friction=0.1:0.8"
  std::vector<std::string> tolerances;  // "angle_of_repose=0.5", or "0.5" for every target
  std::optional<int> seeds;             // runs at the result; absent: 3, or 1 without a seed
  bool quick = false;                   // the scene's quick preset
  int jobs = 2;                         // runs at a time
  int dem_ranks = 1;                    // of each run
  std::filesystem::path out;            // empty: results/calibrate/<scene name>
  bool no_plots = false;
};

}  // namespace gasgrain
