// What a calibration says on the terminal.
#pragma once

#include <string>

#include "tools/calibrate/refine.h"

namespace gasgrain {

// "point 3  friction=0.42  angle_of_repose 27.6 +- 0.4 (2 runs, target 28 +- 0.56)"
std::string point_text(const CalibrationProblem& problem, int number,
                       const CalibrationPoint& point);

// The values with their uncertainty, what is measured there, and, when the targets are not met,
// what was reached and the remedy.
std::string result_text(const Objective& objective, const Calibration& result);

}  // namespace gasgrain
