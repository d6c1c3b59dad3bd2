// How far a study is: a line redrawn in place on a terminal, a plain line now and then else.
#pragma once

#include <chrono>
#include <string>

namespace gasgrain {

class StudyProgress {
 public:
  // `expected`: the sum of all points' expected costs.
  explicit StudyProgress(double expected);

  // The next point: its share of the whole, and whether it needs no time, being there already.
  void begin(const std::string& text, double expected, bool there_already);
  // Its share that is done, from 0 to 1.
  void look(double share);
  // The point has ended; `line` is told of it.
  void end(const std::string& line);

 private:
  void show(double share);
  void clear_line() const;

  using Clock = std::chrono::steady_clock;
  double expected_;
  double done_ = 0.0;     // of the expected cost, found there already included
  double skipped_ = 0.0;  // found there already: says nothing about the pace
  double current_ = 0.0;
  bool there_already_ = false;
  std::string text_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace gasgrain
