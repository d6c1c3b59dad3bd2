// What is looked for: parameters within their ranges that meet measured values.
#pragma once

#include <string>
#include <vector>

#include "tools/calibrate/calibrate_options.h"

namespace gasgrain {

struct CalibrationTarget {
  std::string name;  // of a quantity that the scene measures
  double value = 0.0;
  double tolerance = 0.0;  // in the quantity's unit; above 0
};

struct CalibrationParameter {
  std::string name;  // of an index variable of in.liggghts
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] double span() const { return high - low; }
};

struct CalibrationProblem {
  std::vector<CalibrationTarget> targets;
  std::vector<CalibrationParameter> parameters;
  std::vector<long> seeds;  // one a repeat, the scene's own first; {0}: the scene has no seed
  int search_repeats = 1;   // of the seeds, those that a point of the search is run with
  bool has_seed = false;
};

// Share of a target's value that is its tolerance when none is given.
constexpr double usual_tolerance = 0.02;

// Throws an Error that tells every fault of the request, with the `faults` of the scene that were
// found already.
CalibrationProblem calibration_problem(const CalibrateOptions& options,
                                       std::vector<std::string> faults = {});

}  // namespace gasgrain
