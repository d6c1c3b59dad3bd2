#include "tools/analyse/drag_rates.h"

#include <algorithm>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

// `content` as often as a frame has steps.
PhaseContent times(const PhaseContent& content, double steps) {
  return {steps * content.volume, steps * content.volume_flow, steps * content.force};
}

}  // namespace

double DragRate::omega() const {
  return dem.dot(syamlal) / syamlal.squaredNorm();
}

DragRates::DragRates(RunFacts facts, std::vector<double> sizes, double small_diameter, long steps)
    : facts_(facts),
      sizes_(std::move(sizes)),
      small_diameter_(small_diameter),
      window_steps_(steps) {}

void DragRates::add(const Phases& phases, long spacing) {
  // A frame at the very end of a window, its mean force included, belongs to that window.
  const long since = phases.step - facts_.first_step;
  if (since < spacing) return;  // no whole interval lies before it
  const long window = (since - 1) / window_steps_;
  for (const auto& grain : phases.big) {
    for (std::size_t n = 0; n < sizes_.size(); ++n) {
      Sum& sum = sums_[{n, grain.id, window}];
      sum.side = sizes_[n] * (small_diameter_ + 2.0 * grain.radius);
      if (0.5 * sum.side > (1.0 + 1e-9) * facts_.reach)
        fail(
            "--sizes {:g}: a cube of {:g} m reaches beyond what the dumps hold, {:g} m to each "
            "side "
            "of the big grain. At most {:.3g}, or dump more.",
            sizes_[n], sum.side, facts_.reach, sizes_[n] * 2.0 * facts_.reach / sum.side);
      sum.steps += spacing;
      sum.big_diameter = 2.0 * grain.radius;
      const auto share = static_cast<double>(spacing);
      sum.small.add(times(content_of(phases.small, grain.position, sum.side), share));
      sum.big.add(times(content_of(phases.big, grain.position, sum.side), share));
    }
  }
}

DragRate DragRates::rate(double size, int id, long window, const Sum& sum) const {
  const double volume = sum.side * sum.side * sum.side;
  const auto steps = static_cast<double>(sum.steps);
  DragRate rate;
  rate.time_s = static_cast<double>((window + 1) * window_steps_) * facts_.timestep_s;
  rate.big_id = id;
  rate.size = size;
  rate.side = sum.side;
  rate.s = {sum.small.volume / volume / steps, facts_.density, small_diameter_,
            sum.small.velocity()};
  rate.b = {sum.big.volume / volume / steps, facts_.density_big, sum.big_diameter,
            sum.big.velocity()};
  rate.dem = -sum.big.force / volume / steps;
  if (rate.s.fraction > 0.0)
    rate.syamlal = syamlal_drag(rate.s, rate.b, facts_.restitution, facts_.friction);
  return rate;
}

std::vector<DragRate> DragRates::rates() const {
  std::vector<DragRate> all;
  for (const auto& [key, sum] : sums_) {
    const auto& [size, id, window] = key;
    if (sum.steps == window_steps_) all.push_back(rate(sizes_[size], id, window, sum));
  }
  return all;
}

long DragRates::left_over() const {
  long steps = 0;
  for (const auto& [key, sum] : sums_)
    if (sum.steps < window_steps_) steps = std::max(steps, sum.steps);
  return steps;
}

}  // namespace gasgrain
