#include "tools/calibrate/local_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

// In ranges of the parameters.
double distance(const CalibrationProblem& problem, const std::vector<double>& one,
                const std::vector<double>& other) {
  double squares = 0.0;
  for (std::size_t n = 0; n < one.size(); ++n)
    squares += std::pow((one[n] - other[n]) / problem.parameters[n].span(), 2.0);
  return std::sqrt(squares);
}

// Beyond it a point does not count.
double reach(const Objective& objective, const std::vector<double>& centre) {
  constexpr double shortest = 0.15;
  constexpr double beyond = 1.5;
  std::vector<double> distances;
  for (const auto& point : objective.points())
    distances.push_back(distance(objective.problem(), point.values, centre));
  std::sort(distances.begin(), distances.end());
  const std::size_t needed = centre.size() + 1;
  return std::max(shortest, beyond * distances[std::min(distances.size() - 1, needed)]);
}

}  // namespace

Eigen::MatrixXd LocalFit::inverse_slope() const {
  return slope.completeOrthogonalDecomposition().pseudoInverse();
}

LocalFit local_fit(const Objective& objective, const std::vector<double>& centre) {
  const auto& problem = objective.problem();
  const auto rows = static_cast<Eigen::Index>(objective.runs().size());
  const auto parameters = static_cast<Eigen::Index>(centre.size());
  const auto targets = static_cast<Eigen::Index>(problem.targets.size());
  const double farthest = reach(objective, centre);
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(rows, parameters + 1);
  Eigen::MatrixXd measured = Eigen::MatrixXd::Zero(rows, targets);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto& run = objective.runs()[static_cast<std::size_t>(row)];
    const double share = std::min(1.0, distance(problem, run.request.values, centre) / farthest);
    const double weight = std::sqrt(std::pow(1.0 - std::pow(share, 3.0), 3.0));
    terms(row, 0) = weight;
    for (Eigen::Index n = 0; n < parameters; ++n) {
      const auto at = static_cast<std::size_t>(n);
      terms(row, n + 1) =
          weight * (run.request.values[at] - centre[at]) / problem.parameters[at].span();
    }
    for (Eigen::Index n = 0; n < targets; ++n)
      measured(row, n) = weight * run.outcome.measured[static_cast<std::size_t>(n)];
  }
  const Eigen::MatrixXd plane = terms.colPivHouseholderQr().solve(measured);
  LocalFit fit;
  fit.level = plane.row(0);
  fit.slope = plane.bottomRows(parameters).transpose();
  for (Eigen::Index n = 0; n < parameters; ++n) {
    const auto& parameter = problem.parameters[static_cast<std::size_t>(n)];
    // Round-off of the measured numbers as they are written.
    constexpr double nothing = 1e-9;
    double effect = 0.0;
    for (Eigen::Index i = 0; i < targets; ++i)
      effect = std::max(effect, std::abs(fit.slope(i, n)) /
                                    problem.targets[static_cast<std::size_t>(i)].tolerance);
    if (!(effect > nothing))
      fail("{} has no effect on what is measured: leave out --vary {}.", parameter.name,
           parameter.name);
    fit.slope.col(n) /= parameter.span();
  }
  return fit;
}

}  // namespace gasgrain
