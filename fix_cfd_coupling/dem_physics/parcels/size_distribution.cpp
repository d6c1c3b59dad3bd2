#include "fix_cfd_coupling/dem_physics/parcels/size_distribution.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {

namespace {

constexpr double cut_deviations = 3.0;  // of a lognormal law
constexpr double cut_share = 1e-3;      // of Rosin and Rammler's

double normal_share(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

// The z with normal_share(z) = q, for q within the cut, by bisection: exact to round-off.
double normal_quantile(double q) {
  double low = -cut_deviations;
  double high = cut_deviations;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (low + high);
    (normal_share(middle) < q ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double SizeDistribution::quantile(double q) const {
  switch (law) {
    case Law::constant:
      return radius;
    case Law::lognormal: {
      const double below = normal_share(-cut_deviations);
      return radius * std::exp(width * normal_quantile(below + q * (1.0 - 2.0 * below)));
    }
    case Law::rosin_rammler: {
      const double within = cut_share + q * (1.0 - 2.0 * cut_share);
      return radius * std::pow(-std::log1p(-within), 1.0 / width);
    }
    case Law::list: {
      double sum = 0.0;
      for (const auto& [r, share] : list) sum += share;
      double finer = 0.0;
      for (const auto& [r, share] : list) {
        finer += share / sum;
        if (q <= finer) return r;
      }
      return list.back().first;
    }
  }
  return radius;
}

}  // namespace gasgrain
