// What dumps do not tell of a run: its time step and the grains' material. Of the command line,
// else of analyse.toml, which a script writes into its results, else (the step) of run.json.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tools/analyse/analyse_options.h"

namespace gasgrain {

struct RunFacts {
  double timestep_s = 0.0;
  long first_step = 0;  // at time 0
  double restitution = 0.0;
  double friction = 0.0;
  double density = 0.0;      // kg/m3
  double density_big = 0.0;  // kg/m3
  // The dumps hold the cube of this half side about each big grain [m].
  double reach = std::numeric_limits<double>::infinity();
};

// Adds a fault for each fact that is absent or out of range. Throws when analyse.toml is at fault.
RunFacts run_facts(const AnalyseOptions& options, std::vector<std::string>& faults);

}  // namespace gasgrain
