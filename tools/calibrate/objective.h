// The scene as a function: parameters in, measured quantities out, as mean and standard error over
// runs with different seeds. A run is made once, whoever asks for it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/calibrate/calibration_problem.h"

namespace gasgrain {

struct RunRequest {
  std::vector<double> values;  // of the parameters
  long seed = 0;
};

struct RunOutcome {
  std::vector<double> measured;  // of the targets
  double wall_s = 0.0;
};

struct CalibrationRun {
  RunRequest request;
  RunOutcome outcome;
  int point = 0;  // from 1 on, in the order of the search
};

// Runs with the same values of the parameters.
struct CalibrationPoint {
  std::vector<double> values;
  std::vector<double> mean;            // of each target
  std::vector<double> standard_error;  // of each mean; 0 for one run
  int repeats = 0;

  // The greatest distance to a target, in units of its tolerance.
  [[nodiscard]] double distance(const CalibrationProblem& problem) const;
};

class Objective {
 public:
  // Makes runs that do not depend on each other, as many at a time as it likes.
  using Perform = std::function<std::vector<RunOutcome>(const std::vector<RunRequest>&)>;
  // Is told of each point that has been measured, and of all runs up to there.
  using Tell =
      std::function<void(int number, const CalibrationPoint&, const std::vector<CalibrationRun>&)>;

  Objective(CalibrationProblem problem, Perform perform, Tell tell = {});

  // The points with the first `repeats` seeds; all runs that are missing are asked for at once.
  std::vector<CalibrationPoint> measure_all(const std::vector<std::vector<double>>& values,
                                            int repeats);
  CalibrationPoint measure(const std::vector<double>& values, int repeats);

  [[nodiscard]] const CalibrationProblem& problem() const { return problem_; }
  [[nodiscard]] const std::vector<CalibrationRun>& runs() const { return runs_; }
  // Every point as it stands, in the order of the search.
  [[nodiscard]] std::vector<CalibrationPoint> points() const;
  // Standard deviation of a single run around the mean of its point, from all points with repeats
  // together: three runs alone tell their scatter to about half only. Assumes that it is the same
  // all over the range.
  [[nodiscard]] double scatter(std::size_t target) const;

 private:
  [[nodiscard]] const CalibrationRun* find(const RunRequest& request) const;
  [[nodiscard]] CalibrationPoint point(const std::vector<double>& values) const;
  int number_of(const std::vector<double>& values);

  CalibrationProblem problem_;
  Perform perform_;
  Tell tell_;
  std::vector<CalibrationRun> runs_;
  std::vector<std::vector<double>> points_;
};

// The whole figures in which a parameter is written, handed to a run and told to the user.
std::string value_text(double value);
// The value that this text stands for: what is searched is what is run.
double as_written(double value);

}  // namespace gasgrain
