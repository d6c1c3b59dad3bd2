#include "tools/analyse/drag_reading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/base/error.h"

namespace gasgrain {

void DragReading::add(const DumpFrame& frame) {
  if (last_step_) learn_spacing(frame.step() - *last_step_);
  last_step_ = frame.step();
  if (frame.size() == 0) return;  // nothing is inserted yet
  if (!force_) force_ = force_columns(frame, options_.force);
  Phases phases = phases_of(frame, big_, *force_);
  if (phases.big.empty()) return;
  check_largest(phases);
  if (small_diameter_ == 0.0 && !phases.small.empty()) learn_small_diameter(phases.small);
  waiting_.push_back(std::move(phases));
  if (spacing_ == 0 || small_diameter_ == 0.0) return;
  if (!rates_) rates_.emplace(facts_, options_.sizes, small_diameter_, window_steps_);
  for (const auto& one : waiting_) rates_->add(one, spacing_);
  waiting_.clear();
}

const DragRates& DragReading::rates() const {
  if (!last_step_) fail("The dumps have no frame.");
  if (spacing_ == 0) fail("The dumps have one frame alone: windows need two and more.");
  if (big_radius_ == 0.0)
    fail("--big {}: the dumps have no such grain. Choose by type=..., id=... or above=... (m).",
         options_.big);
  if (!rates_)
    fail(
        "--big {}: there are no small grains beside the big ones. Choose by type=..., id=... or "
        "above=... (m).",
        options_.big);
  return *rates_;
}

// What is the largest at first may be a small grain, the big ones not being there yet.
void DragReading::check_largest(const Phases& phases) {
  const double radius = phases.big.front().radius;
  if (big_radius_ == 0.0) big_radius_ = radius;
  constexpr double alike = 1e-3;
  if (options_.big == "largest" && std::abs(radius - big_radius_) > alike * big_radius_)
    fail(
        "--big largest: the largest grains are of {:g} m first, of {:g} m at step {}. Choose by "
        "type=..., id=... or above=... (m).",
        2.0 * big_radius_, 2.0 * radius, phases.step);
}

void DragReading::learn_spacing(long spacing) {
  if (spacing_ != 0 && spacing != spacing_)
    fail(
        "A dump comes {} steps after the one before, the earlier ones {}: windows need dumps that "
        "are evenly spaced.",
        spacing, spacing_);
  if (spacing_ != 0) return;
  spacing_ = spacing;
  const double between = static_cast<double>(spacing) * facts_.timestep_s;
  const double frames = options_.window_s / between;
  constexpr double near = 0.01;  // a step that divides no round time
  if (frames < 1.0 - near || std::abs(frames - std::round(frames)) > near * frames)
    fail(
        "--window {:g} s must be a whole number of the {:g} s from dump to dump, to 1 %: for "
        "example {:g}.",
        options_.window_s, between, std::max(1.0, std::round(frames)) * between);
  window_steps_ = spacing * std::lround(frames);
}

void DragReading::learn_small_diameter(const std::vector<MovingGrain>& small) {
  double cubes = 0.0;
  double squares = 0.0;
  for (const auto& grain : small) {
    cubes += 8.0 * grain.radius * grain.radius * grain.radius;
    squares += 4.0 * grain.radius * grain.radius;
  }
  small_diameter_ = cubes / squares;
}

}  // namespace gasgrain
