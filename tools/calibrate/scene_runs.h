// The runs of a calibration: `gasgrain run` with values set, several at a time, each in a folder of
// its own. A run whose results are there already is not made again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/calibrate/calibrate_progress.h"
#include "tools/calibrate/objective.h"

namespace gasgrain {

// Thrown after Ctrl-C.
struct CalibrationStopped {};

class SceneRuns {
 public:
  // The runs are in `folder`.
  SceneRuns(CalibrateOptions options, CalibrationProblem problem, std::filesystem::path folder);

  // Throws an Error that says which run failed and why; the other runs are ended then.
  std::vector<RunOutcome> perform(const std::vector<RunRequest>& requests);

 private:
  struct Running;

  [[nodiscard]] std::string name(const RunRequest& request) const;
  [[nodiscard]] std::filesystem::path results(const RunRequest& request) const;
  // True when the results of a finished run are there; `outcome` is what it measured.
  bool read_done(const RunRequest& request, RunOutcome& outcome) const;
  void finish(const Running& run, RunOutcome& outcome) const;

  CalibrateOptions options_;
  CalibrationProblem problem_;
  std::filesystem::path folder_;
  std::string state_;  // of the scene and of what all runs share
  CalibrateProgress progress_;
};

}  // namespace gasgrain
