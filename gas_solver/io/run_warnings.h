// What a run did that a good one does without: tolerances missed, values cut, gas drawn in through
// an outlet. Counted over its intervals, and told at its end.
#pragma once

#include <string>

#include "gas_solver/gas_step.h"

namespace gasgrain {

class RunWarnings {
 public:
  void add(const GasReport& report);
  // A line each of what is not 0; empty when nothing is.
  [[nodiscard]] std::string text() const;

 private:
  long momentum_ = 0;
  long pressure_ = 0;
  long outer_ = 0;
  long turbulence_clamped_ = 0;
  long turbulence_ = 0;
  long backflow_ = 0;
};

}  // namespace gasgrain
