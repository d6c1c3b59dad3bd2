// The end of a calibration: all seeds at what the search found, a correction where their mean is
// off, and how well the parameters are known.
#pragma once

#include "tools/calibrate/search.h"

namespace gasgrain {

struct Calibration {
  CalibrationPoint point;                   // with all seeds
  std::vector<double> uncertainty;          // of each parameter, see below
  std::vector<double> allowed;              // the change of each that the tolerances allow for
  std::vector<std::vector<double>> slopes;  // of each target over each parameter
  bool met = false;                         // every mean is within the tolerance of its target
  std::string out_of_reach;                 // why not, when no values in the range can
};

// With J the slopes of the quantities over the parameters (local_fit.h), s_i the scatter of a run
// (Objective::scatter), n the seeds and d_i the tolerances:
//   uncertainty_j = sqrt(sum_i (J^-1_ji s_i / sqrt n)^2),   allowed_j = sum_i |J^-1_ji d_i|.
// For one parameter both are the quantity's figure divided by the slope's absolute value. A mean
// outside its tolerance is corrected up to three times, each time by J^-1 (target - level), with
// all runs up to there in the fit.
Calibration refine(Objective& objective, const SearchResult& found);

}  // namespace gasgrain
