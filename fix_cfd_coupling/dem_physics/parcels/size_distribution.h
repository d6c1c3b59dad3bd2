// Radii of injected particles, distributed by MASS: the share of the mass flow in particles of up
// to a radius.
//
//   constant R
//   lognormal R_50 S        ln R normal about ln R_50 with standard deviation S, cut at 3 S
//   rosin_rammler R_63 N    1 - exp(-(R / R_63)^N), cut where 0.1 % are below or above
//   list R W R W ...        radii with their shares (of any sum)
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gasgrain {

struct SizeDistribution {
  enum class Law { constant, lognormal, rosin_rammler, list };

  Law law = Law::constant;
  double radius = 0.0;                          // R, R_50 or R_63 [m]
  double width = 0.0;                           // S or N
  std::vector<std::pair<double, double>> list;  // radius [m], share

  // The radius [m] that the share `q` of the mass, from above 0 to below 1, is finer than.
  [[nodiscard]] double quantile(double q) const;
};

}  // namespace gasgrain
