// What share of the force loop's time each of its effects has.
//
// A clock read around each force at every step would cost a part of what it measures, so one step
// in `steps_a_sample` is timed pass by pass (a pass over a block of particles is one effect, or
// what every step reads and books whatever the effects are). The results of a timed step are those
// of any other.
//
// Drag, virtual mass and history are one pass, since they are solved together. Its time is divided
// by what each of them adds when they are switched on one after the other, on copies of a block
// (ForceLoop::time_solve); the first one has the frame of the pass with it.
#pragma once

#include <algorithm>
#include <vector>

#include "coupling/base/cost_ledger.h"

namespace gasgrain {

class ForceCosts {
 public:
  // `effects`: number of Effects::names(); one row each, and a last one for what every step does.
  explicit ForceCosts(std::size_t effects)
      : passes_(effects + 1, 0.0), parts_of_solve_(effects + 1, 0.0) {}

  [[nodiscard]] std::size_t rows() const { return passes_.size(); }
  [[nodiscard]] std::size_t row_of_every_step() const { return passes_.size() - 1; }
  // Of the loop; all rows' sum to 1 once a step has been timed.
  [[nodiscard]] double share(std::size_t row) const {
    const double whole = sum(passes_) + solve_;
    if (!(whole > 0.0)) return row == row_of_every_step() ? 1.0 : 0.0;
    const double parts = sum(parts_of_solve_);
    return (passes_[row] + (parts > 0.0 ? solve_ * parts_of_solve_[row] / parts : 0.0)) / whole;
  }

  // Whether the step that begins is timed.
  bool begin_step() {
    timed_ = steps_++ % steps_a_sample == 0;
    start();
    return timed_;
  }
  // Whether the parts of the solve are to be timed in this step.
  [[nodiscard]] bool wants_parts() const {
    return timed_ &&
           ((steps_ - 1) % (steps_a_sample * steps_a_sample) == 0 || !(sum(parts_of_solve_) > 0.0));
  }
  // From here to the next pass_done().
  void start() {
    if (timed_) clock_ = WallClock();
  }
  void pass_done(std::size_t row) { add(passes_[row]); }
  void solve_done() { add(solve_); }
  void add_part(std::size_t row, double seconds) { parts_of_solve_[row] += seconds; }

 private:
  static constexpr long steps_a_sample = 16;

  static double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
  }
  void add(double& seconds) {
    if (!timed_) return;
    seconds += clock_.seconds();
    clock_ = WallClock();
  }

  long steps_ = 0;
  bool timed_ = false;
  WallClock clock_;
  std::vector<double> passes_;          // [s] of the timed steps
  std::vector<double> parts_of_solve_;  // in any unit
  double solve_ = 0.0;                  // [s] of the timed steps
};

}  // namespace gasgrain
