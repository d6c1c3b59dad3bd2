// The search: from the ranges of the parameters to a point at which every target is met within its
// tolerance, as far as the few seeds of the search can tell.
#pragma once

#include <string>
#include <vector>

#include "tools/calibrate/objective.h"

namespace gasgrain {

struct SearchResult {
  std::vector<double> values;  // of the parameters: the nearest that was found
  std::string out_of_reach;    // why no values in the range can be; empty when there may be some
};

// One parameter, one target: root of quantity(parameter) - target by TOMS algorithm 748 of
// Boost.Math (Alefeld, Potra & Shi, ACM Trans. Math. Software 21 (1995) 327-344). It keeps the root
// bracketed and takes secant and inverse cubic steps: two runs for the ends, which also tell
// whether the target is within reach, and one to three points between them for a smooth quantity.
// NLopt has no root finder. Its COBYLA, below, is as quick on a smooth quantity; on one that is
// flat at both ends, with scatter, it strays where the bracket holds: an S of 14 degrees with runs
// that scatter by 0.4 was met in 97 % of 500 calibrations against 89 %, with 0.3 against 1.7
// degrees of error. Ends that do not bracket the target: three points between them are tried before
// it is called out of reach, for a quantity need not be monotone.
SearchResult search_root(Objective& objective);

// Several parameters: the greatest distance to a target, in tolerances, is made least by COBYLA
// (Powell 1994) of NLopt, as: minimise t over (parameters, t), subject to
//   -t <= (quantity_i - target_i) / tolerance_i <= t  for every target i.
// COBYLA models each of these quantities as linear over a simplex, which for a calibration is close
// to the truth; the square sum that the other derivative-free methods see has lost it. On pairs of
// smooth quantities with two parameters it took 6.2 points on average, BOBYQA 9.3, the subspace
// simplex 18.
SearchResult search_minimax(Objective& objective);

// The one or the other.
SearchResult search(Objective& objective);

// "friction=0.1" ..., for messages.
std::string values_text(const CalibrationProblem& problem, const std::vector<double>& values);
// The least and the greatest of a quantity over all points.
std::string reached_text(const Objective& objective, std::size_t target);

}  // namespace gasgrain
