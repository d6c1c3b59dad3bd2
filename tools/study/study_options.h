// What the user asks of `gasgrain study`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gasgrain {

struct StudyOptions {
  std::string kind;
  std::filesystem::path scene;
  std::vector<std::string> values;  // of the kind's dial; empty: the kind's own
  std::optional<double> time_s;     // gas time of a point; absent: the preset's
  bool quick = false;               // few values, short runs
  int repeats = 1;                  // runs a point; its cost is their median
  int dem_ranks = 1;
  int gas_ranks = 1;
  std::filesystem::path out;  // empty: results/study/<scene name>/<kind>
  bool no_plots = false;
};

}  // namespace gasgrain
