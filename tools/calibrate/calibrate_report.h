// What a calibration leaves: calibration.csv (every run), calibration.json (for the picture and for
// programs), calibrated.txt (the lines for a script).
#pragma once

#include <filesystem>
#include <string>

#include "tools/calibrate/refine.h"

namespace gasgrain {

void write_runs(const std::filesystem::path& folder, const CalibrationProblem& problem,
                const std::vector<CalibrationRun>& runs);

// calibration.json, and calibrated.txt when the targets are met.
void write_result(const std::filesystem::path& folder, const std::string& command,
                  const std::filesystem::path& scene, const Objective& objective,
                  const Calibration& result);

}  // namespace gasgrain
