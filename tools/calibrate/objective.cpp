#include "tools/calibrate/objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gasgrain {

std::string value_text(double value) {
  return fmt::format("{:.5g}", value);
}

double as_written(double value) {
  return std::stod(value_text(value));
}

double CalibrationPoint::distance(const CalibrationProblem& problem) const {
  double greatest = 0.0;
  for (std::size_t n = 0; n < mean.size(); ++n)
    greatest = std::max(
        greatest, std::abs(mean[n] - problem.targets[n].value) / problem.targets[n].tolerance);
  return greatest;
}

Objective::Objective(CalibrationProblem problem, Perform perform, Tell tell)
    : problem_(std::move(problem)), perform_(std::move(perform)), tell_(std::move(tell)) {}

const CalibrationRun* Objective::find(const RunRequest& request) const {
  for (const auto& run : runs_)
    if (run.request.values == request.values && run.request.seed == request.seed) return &run;
  return nullptr;
}

int Objective::number_of(const std::vector<double>& values) {
  const auto found = std::find(points_.begin(), points_.end(), values);
  const auto number = static_cast<int>(found - points_.begin()) + 1;
  if (found == points_.end()) points_.push_back(values);
  return number;
}

std::vector<CalibrationPoint> Objective::measure_all(const std::vector<std::vector<double>>& values,
                                                     int repeats) {
  std::vector<RunRequest> missing;
  std::vector<std::vector<double>> written;
  std::vector<bool> is_new;
  for (const auto& point : values) {
    written.emplace_back();
    for (const double value : point) written.back().push_back(as_written(value));
    const std::size_t before = missing.size();
    for (int n = 0; n < repeats; ++n) {
      const RunRequest request{written.back(), problem_.seeds[static_cast<std::size_t>(n)]};
      if (find(request) == nullptr) missing.push_back(request);
    }
    is_new.push_back(missing.size() > before);
  }
  const auto outcomes = missing.empty() ? std::vector<RunOutcome>{} : perform_(missing);
  for (std::size_t n = 0; n < missing.size(); ++n)
    runs_.push_back({missing[n], outcomes[n], number_of(missing[n].values)});
  std::vector<CalibrationPoint> result;
  for (std::size_t n = 0; n < written.size(); ++n) {
    result.push_back(point(written[n]));
    if (tell_ && is_new[n]) tell_(number_of(written[n]), result.back(), runs_);
  }
  return result;
}

CalibrationPoint Objective::measure(const std::vector<double>& values, int repeats) {
  return measure_all({values}, repeats).front();
}

CalibrationPoint Objective::point(const std::vector<double>& values) const {
  CalibrationPoint result;
  result.values = values;
  result.mean.assign(problem_.targets.size(), 0.0);
  result.standard_error = result.mean;
  std::vector<const CalibrationRun*> own;
  for (const auto& run : runs_)
    if (run.request.values == values) own.push_back(&run);
  const auto count = static_cast<double>(own.size());
  result.repeats = static_cast<int>(own.size());
  for (std::size_t n = 0; n < result.mean.size(); ++n) {
    double squares = 0.0;
    for (const auto* run : own) result.mean[n] += run->outcome.measured[n] / count;
    for (const auto* run : own) squares += std::pow(run->outcome.measured[n] - result.mean[n], 2.0);
    if (own.size() > 1) result.standard_error[n] = std::sqrt(squares / (count - 1.0) / count);
  }
  return result;
}

double Objective::scatter(std::size_t target) const {
  double squares = 0.0;
  int freedom = 0;
  for (const auto& point : points()) {
    // A standard error is that of the mean: squared, times n (n - 1), the sum of squares.
    squares += std::pow(point.standard_error[target], 2.0) * point.repeats * (point.repeats - 1);
    freedom += point.repeats - 1;
  }
  return freedom > 0 ? std::sqrt(squares / freedom) : 0.0;
}

std::vector<CalibrationPoint> Objective::points() const {
  std::vector<CalibrationPoint> result;
  result.reserve(points_.size());
  for (const auto& values : points_) result.push_back(point(values));
  return result;
}

}  // namespace gasgrain
