#include "tools/calibrate/refine.h"

#include <algorithm>
#include <cmath>

#include "tools/calibrate/local_fit.h"

namespace gasgrain {
namespace {

constexpr int most_corrections = 3;

std::vector<double> corrected(const Objective& objective, const LocalFit& fit,
                              const std::vector<double>& from) {
  const auto& problem = objective.problem();
  Eigen::VectorXd lacking(fit.level.size());
  for (Eigen::Index n = 0; n < lacking.size(); ++n)
    lacking(n) = problem.targets[static_cast<std::size_t>(n)].value - fit.level(n);
  const Eigen::VectorXd step = fit.inverse_slope() * lacking;
  std::vector<double> values = from;
  for (std::size_t n = 0; n < values.size(); ++n) {
    const auto& parameter = problem.parameters[n];
    values[n] =
        std::clamp(values[n] + step(static_cast<Eigen::Index>(n)), parameter.low, parameter.high);
  }
  return values;
}

// A search that ended at once has not moved every parameter: one more point for each then.
void measure_for_slopes(Objective& objective, const std::vector<double>& from) {
  const auto& problem = objective.problem();
  if (objective.points().size() > problem.parameters.size()) return;
  constexpr double step = 0.25;  // of the range
  std::vector<std::vector<double>> around;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const auto& parameter = problem.parameters[n];
    const double move = step * parameter.span();
    around.push_back(from);
    around.back()[n] += from[n] + move <= parameter.high ? move : -move;
  }
  objective.measure_all(around, 1);
}

}  // namespace

Calibration refine(Objective& objective, const SearchResult& found) {
  const CalibrationProblem& problem = objective.problem();
  Calibration result;
  result.out_of_reach = found.out_of_reach;
  const auto repeats = found.out_of_reach.empty() ? static_cast<int>(problem.seeds.size()) : 1;
  result.point = objective.measure(found.values, repeats);
  if (!found.out_of_reach.empty()) return result;
  measure_for_slopes(objective, result.point.values);
  auto latest = result.point;
  for (int n = 0; n < most_corrections && result.point.distance(problem) > 1.0; ++n) {
    latest = objective.measure(
        corrected(objective, local_fit(objective, latest.values), latest.values), repeats);
    if (latest.distance(problem) < result.point.distance(problem)) result.point = latest;
  }
  result.met = result.point.distance(problem) <= 1.0;
  const LocalFit fit = local_fit(objective, result.point.values);
  const Eigen::MatrixXd inverse = fit.inverse_slope();
  for (Eigen::Index j = 0; j < inverse.rows(); ++j) {
    double squares = 0.0;
    double allowed = 0.0;
    for (Eigen::Index i = 0; i < inverse.cols(); ++i) {
      const auto target = static_cast<std::size_t>(i);
      squares += std::pow(inverse(j, i) * objective.scatter(target), 2.0) / repeats;
      allowed += std::abs(inverse(j, i)) * problem.targets[target].tolerance;
    }
    result.uncertainty.push_back(std::sqrt(squares));
    result.allowed.push_back(allowed);
  }
  for (Eigen::Index i = 0; i < fit.slope.rows(); ++i) {
    const Eigen::VectorXd row = fit.slope.row(i);
    result.slopes.emplace_back(row.begin(), row.end());
  }
  return result;
}

}  // namespace gasgrain
