// `gasgrain advise`: which effects and numerics a scene calls for, before it runs.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/advise_numerics.h"

namespace gasgrain {

struct AdviseOptions {
  std::filesystem::path scene;
  double overlap_percent = 100.0 * NumericsWish{}.overlap;
  double speed = 0.0;  // [m/s]; 0: estimated
  bool json = false;
  std::filesystem::path write;  // folder of the copy; empty: none
  std::vector<std::pair<std::string, std::string>> variables;
};

// The exit status. Throws Error when the scene cannot be read.
int advise(const AdviseOptions& options);

}  // namespace gasgrain
