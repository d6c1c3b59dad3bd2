// How measured quantities change with the parameters near a point: a plane through the runs around
// it, by weighted least squares.
#pragma once

#include <Eigen/Core>

#include "tools/calibrate/objective.h"

namespace gasgrain {

// Model: quantity_i = level_i + sum_j slope_ij (parameter_j - centre_j). Weights are tricube in the
// distance to the centre, in ranges of the parameters (Cleveland, J. Am. Stat. Assoc. 74 (1979)
// 829-836), and reach half as far again as the first point beyond those that the plane needs, and
// no less than 0.15 of the range: points that lie closer differ by scatter rather than by the
// parameter.
struct LocalFit {
  Eigen::VectorXd level;  // of each target, at the centre
  Eigen::MatrixXd slope;  // targets x parameters

  // Parameters in the direction of a change of the quantities: pseudo-inverse of the slope.
  [[nodiscard]] Eigen::MatrixXd inverse_slope() const;
};

// Throws an Error that names the parameter when the runs do not tell the effect of one.
LocalFit local_fit(const Objective& objective, const std::vector<double>& centre);

}  // namespace gasgrain
