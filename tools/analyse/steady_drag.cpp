#include "tools/analyse/steady_drag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "coupling/base/error.h"
#include "tools/measure/series.h"

namespace gasgrain {

namespace {

constexpr double worth_counting = 0.1;  // of the greatest, or of the mean, rate
constexpr int blocks = 4;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A window's end lies in the period; round-off of the time does not put it out.
bool within(double time_s, const std::array<double, 2>& period) {
  const double room = 1e-9 * (period[1] - period[0]);
  return time_s > period[0] + room && time_s <= period[1] + room;
}

SteadyDrag mean_of(const std::vector<const DragRate*>& rates, const std::array<double, 2>& period) {
  SteadyDrag mean;
  Vec3 dem = Vec3::Zero();
  Vec3 syamlal = Vec3::Zero();
  std::vector<double> omegas;
  for (const DragRate* rate : rates) {
    if (!within(rate->time_s, period)) continue;
    ++mean.windows;
    mean.size = rate->size;
    mean.side += rate->side;
    mean.alpha_s += rate->s.fraction;
    mean.alpha_b += rate->b.fraction;
    mean.slip += (rate->b.velocity - rate->s.velocity).norm();
    dem += rate->dem;
    syamlal += rate->syamlal;
    if (std::isfinite(rate->omega())) omegas.push_back(rate->omega());
  }
  if (mean.windows == 0)
    fail(
        "--steady: no window ends between {:g} and {:g} s; the windows end between {:g} and {:g} "
        "s.",
        period[0], period[1], rates.front()->time_s, rates.back()->time_s);
  for (double* sum : {&mean.side, &mean.alpha_s, &mean.alpha_b, &mean.slip}) *sum /= mean.windows;
  mean.syamlal = syamlal.norm() / mean.windows;
  mean.dem = dem.dot(syamlal.normalized()) / mean.windows;
  mean.omega = mean.dem / mean.syamlal;
  mean.omega_error = omegas.size() >= blocks ? block_mean(omegas, blocks).uncertainty : none;
  mean.omega_transient = none;
  for (const DragRate* rate : rates)
    if (rate->time_s <= period[0] && std::isfinite(rate->omega()) &&
        rate->dem.norm() >= worth_counting * std::abs(mean.dem))
      mean.omega_transient = std::fmax(mean.omega_transient, rate->omega());
  return mean;
}

}  // namespace

std::array<double, 2> steady_period(const std::vector<DragRate>& rates, double window_s) {
  if (rates.empty()) fail("The dumps fill no window of {:g} s: give a shorter --window.", window_s);
  std::map<double, double> force;  // of all big grains, by the end of a window
  for (const auto& rate : rates)
    if (rate.size == rates.front().size)
      force[rate.time_s] += rate.dem.norm() * rate.side * rate.side * rate.side;
  double greatest = 0.0;
  for (const auto& window : force) greatest = std::max(greatest, window.second);
  double first = force.begin()->first - window_s;
  double last = force.rbegin()->first;
  if (!(greatest > 0.0)) return {first, last};
  const auto counts = [&](const auto& window) {
    return window.second >= worth_counting * greatest;
  };
  first = std::find_if(force.begin(), force.end(), counts)->first - window_s;
  last = std::find_if(force.rbegin(), force.rend(), counts)->first;
  if (last - first < 1.5 * window_s) return {first, last};  // one window has no middle
  const double quarter = 0.25 * (last - first);
  return {first + quarter, last - quarter};
}

std::vector<SteadyDrag> steady_drag(const std::vector<DragRate>& rates,
                                    const std::array<double, 2>& period) {
  std::vector<std::vector<const DragRate*>> by_size;
  for (const auto& rate : rates) {
    if (by_size.empty() || by_size.back().front()->size != rate.size) by_size.emplace_back();
    by_size.back().push_back(&rate);
  }
  std::vector<SteadyDrag> means;
  for (const auto& one : by_size) means.push_back(mean_of(one, period));
  return means;
}

}  // namespace gasgrain
