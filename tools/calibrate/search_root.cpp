#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "tools/calibrate/search.h"

namespace gasgrain {
namespace {

constexpr double finest = 0.002;            // of the range: no bracket is made narrower
constexpr boost::uintmax_t most_steps = 8;  // each one point; a smooth quantity needs 1 to 3
constexpr int between = 3;                  // points tried when the ends do not bracket

// What the root finder sees. Within the tolerance the target is met: that is 0, which ends it.
double difference(const CalibrationPoint& point, const CalibrationProblem& problem) {
  return point.distance(problem) <= 1.0 ? 0.0 : point.mean[0] - problem.targets[0].value;
}

struct Bracket {
  CalibrationPoint low;
  CalibrationPoint high;
};

// The first neighbours with the target between them, or a point that meets it as both.
bool find_bracket(const std::vector<CalibrationPoint>& points, const CalibrationProblem& problem,
                  Bracket& bracket) {
  for (const auto& point : points)
    if (difference(point, problem) == 0.0) {
      bracket = {point, point};
      return true;
    }
  for (std::size_t n = 1; n < points.size(); ++n)
    if (std::signbit(difference(points[n - 1], problem)) !=
        std::signbit(difference(points[n], problem))) {
      bracket = {points[n - 1], points[n]};
      return true;
    }
  return false;
}

}  // namespace

SearchResult search_root(Objective& objective) {
  const CalibrationProblem& problem = objective.problem();
  const CalibrationParameter& parameter = problem.parameters.front();
  const int repeats = problem.search_repeats;
  const auto nearest = [&] {
    const auto points = objective.points();
    const auto* best = &points.front();
    for (const auto& point : points)
      if (point.distance(problem) < best->distance(problem)) best = &point;
    return best->values;
  };

  // Only the sign counts at the ends: one run each.
  auto points = objective.measure_all({{parameter.low}, {parameter.high}}, 1);
  Bracket bracket;
  if (!find_bracket(points, problem, bracket)) {
    std::vector<std::vector<double>> inner;
    for (int n = 1; n <= between; ++n)
      inner.push_back({parameter.low + parameter.span() * n / (between + 1)});
    const auto more = objective.measure_all(inner, 1);
    points.insert(points.begin() + 1, more.begin(), more.end());
    if (!find_bracket(points, problem, bracket))
      return {nearest(), fmt::format("{} = {:g} is out of reach for {} from {} to {}: {}.",
                                     problem.targets[0].name, problem.targets[0].value,
                                     parameter.name, value_text(parameter.low),
                                     value_text(parameter.high), reached_text(objective, 0))};
  }
  const auto at = [&](double value) {
    return difference(objective.measure({value}, repeats), problem);
  };
  const auto narrow = [&](double low, double high) {
    return high - low < finest * parameter.span();
  };
  const double low = bracket.low.values[0];
  const double high = bracket.high.values[0];
  if (low < high) {
    boost::uintmax_t steps = most_steps;
    boost::math::tools::toms748_solve(at, low, high, difference(bracket.low, problem),
                                      difference(bracket.high, problem), narrow, steps);
  }
  return {nearest(), ""};
}

}  // namespace gasgrain
