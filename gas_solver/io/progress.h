// What a run tells while it goes: how far it is, and when the gas takes steps of its own.
#pragma once

#include <chrono>
#include <string>

#include "gas_solver/gas_step.h"

namespace gasgrain {

// Whether standard output is drawn on a terminal. mpirun gives its ranks a terminal of their own,
// whatever its own output goes to: then it is mpirun's that counts.
bool output_on_terminal();

// '[#####.....] 50 %  1.5 of 3 s  left 0:01:30', the bar that many characters wide.
std::string bar_text(double fraction, double time, double end, double left_s);

// On a terminal a line redrawn in place, a bar with the time left when the run takes longer than a
// few seconds; else a plain line an interval.
class RunProgress {
 public:
  RunProgress(double begin, double end, bool on_terminal);
  void show(const GasReport& report);
  // Puts a text on a line of its own.
  void tell(const std::string& text);
  // Ends the line drawn in place.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  double begin_;  // [s]
  double end_;    // [s]
  bool on_terminal_;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
};

// Tells, once, that the Courant number makes the gas split an interval further than [time] step
// does: this costs time, and whoever waits for it should know.
class SubstepNote {
 public:
  // `time`: of the gas at the run's beginning.
  SubstepNote(const GasInput& input, double time);
  // After an interval; empty when there is nothing to tell.
  std::string after(const GasReport& report);

 private:
  double step_;
  double time_;
  bool told_ = false;
};

}  // namespace gasgrain
