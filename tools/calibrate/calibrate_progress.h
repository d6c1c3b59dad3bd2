// What is running now: a line redrawn in place on a terminal, a plain line now and then else.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace gasgrain {

class CalibrateProgress {
 public:
  CalibrateProgress();
  // `runs`: those under way.
  void look(const std::vector<std::string>& runs);
  // Takes the line away, for a line that stays.
  void clear() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace gasgrain
