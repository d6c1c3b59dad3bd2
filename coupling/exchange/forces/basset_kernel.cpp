#include "coupling/exchange/forces/basset_kernel.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/base/error.h"
#include "coupling/exchange/forces/basset.h"

namespace gasgrain {
namespace {

constexpr double least_tolerance = 1e-4;
constexpr double greatest_tolerance = 0.2;
constexpr int most_terms = 40;

constexpr double present =
    4.0 / 3.0;  // g_0, half of what its formula gives: the step sees its past

// g_m, for the step m steps ago.
double past(double m) {
  constexpr double series_from = 100.0;  // before it the differences are exact to 1e-11
  if (m >= series_from) return (1.0 + 0.0625 / (m * m)) / std::sqrt(m);
  return present * (std::pow(m + 1.0, 1.5) - 2.0 * std::pow(m, 1.5) + std::pow(m - 1.0, 1.5));
}

// Whole numbers from 1 to `last`, spaced evenly in their logarithm.
std::vector<double> samples(double last, int count) {
  std::vector<double> numbers;
  for (int n = 0; n < count; ++n) {
    const double number = std::round(std::pow(last, n / (count - 1.0)));
    if (numbers.empty() || number > numbers.back()) numbers.push_back(number);
  }
  return numbers;
}

struct Fit {
  Eigen::VectorXd rates;  // -ln q
  Eigen::VectorXd weights;
  double error = std::numeric_limits<double>::infinity();
};

// Terms over g_m, one row a sample.
Eigen::MatrixXd relative_terms(const std::vector<double>& numbers, const Eigen::VectorXd& rates) {
  Eigen::MatrixXd rows(numbers.size(), rates.size());
  for (std::size_t n = 0; n < numbers.size(); ++n)
    rows.row(n) = (-numbers[n] * rates.array()).exp().matrix().transpose() / past(numbers[n]);
  return rows;
}

Fit fit(double last, int terms, double fastest) {
  constexpr double slowest = 0.25;  // a horizon
  constexpr int samples_a_term = 20;
  constexpr int times_finer = 10;
  Fit found;
  found.rates = Eigen::VectorXd::LinSpaced(terms, std::log(slowest / last), std::log(fastest))
                    .array()
                    .exp()
                    .matrix();
  const auto errors = [&](int count) -> Eigen::VectorXd {
    const auto rows = relative_terms(samples(last, count), found.rates);
    return rows * found.weights - Eigen::VectorXd::Ones(rows.rows());
  };
  const auto rows = relative_terms(samples(last, samples_a_term * terms), found.rates);
  found.weights = rows.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(rows.rows()));
  found.error = errors(times_finer * samples_a_term * terms).cwiseAbs().maxCoeff();
  return found;
}

Fit fewest_terms(double last, double tolerance) {
  for (int terms = 2; terms <= most_terms; ++terms)
    for (const double fastest : {0.5, 1.0, 2.0, 4.0}) {
      Fit found = fit(last, terms, fastest);
      if (found.error <= tolerance) return found;
    }
  fail(
      "the memory of the Basset force cannot be fitted to {} over {} steps with {} terms: take a "
      "greater tolerance or a shorter horizon.",
      tolerance, last, most_terms);
}

}  // namespace

BassetKernel::BassetKernel(double dt, double horizon, double tolerance)
    : root_dt_(std::sqrt(dt)), error_(0.0) {
  constexpr double least_steps = 10.0;
  if (!(dt > 0.0) || !(horizon >= least_steps * dt))
    fail(
        "the memory of the Basset force needs a step > 0 s (now {}) and a horizon of {} steps or "
        "more (now {} s).",
        dt, least_steps, horizon);
  if (!(tolerance >= least_tolerance) || !(tolerance <= greatest_tolerance))
    fail("the tolerance of the Basset force must be from {} to {} (now {}).", least_tolerance,
         greatest_tolerance, tolerance);
  const Fit found = fewest_terms(std::round(horizon / dt), tolerance);
  error_ = found.error;
  for (const double rate : found.rates) ratios_.push_back(std::exp(-rate));
  weights_.assign(found.weights.begin(), found.weights.end());
}

double BassetKernel::added_mass(const GasProperties& gas, double radius) const {
  return present * root_dt_ * ForceBasset::coefficient(gas, radius);
}

Vec3 BassetKernel::history(const GasProperties& gas, double radius, const double* state) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t j = 0; j < weights_.size(); ++j)
    sum += weights_[j] * Eigen::Map<const Vec3>(state + 3 * j);
  return root_dt_ * ForceBasset::coefficient(gas, radius) * sum;
}

void BassetKernel::advance(double* state, const Vec3& rate) const {
  for (std::size_t j = 0; j < ratios_.size(); ++j) {
    Eigen::Map<Vec3> past_rates(state + 3 * j);
    past_rates = ratios_[j] * (past_rates + rate);
  }
}

}  // namespace gasgrain
