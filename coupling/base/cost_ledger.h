// Seconds by task: what a run spends its wall time on. A task is a name; a Stopwatch charges the
// time of its scope to it.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "coupling/base/communicator.h"

namespace gasgrain {

class CostLedger {
 public:
  // Slot of a task, made when it is new. Ask once, outside of loops.
  std::size_t task(const std::string& name);
  void charge(std::size_t task, double seconds) { seconds_[task] += seconds; }
  [[nodiscard]] double seconds(const std::string& name) const;

  // The task that all others are parts of, where somebody times the whole.
  static constexpr const char* total = "total";
  // Seconds of the total that no other task has been charged with.
  [[nodiscard]] double unnamed() const;

  // Mean and greatest over the ranks of a group, as a JSON object
  //   {"ranks": n, "tasks": {"name": {"mean_s": .., "max_s": ..}, ...}}.
  // Collective; every rank must have made the same tasks in the same order.
  [[nodiscard]] std::string json(const Communicator& comm) const;

 private:
  std::vector<std::string> names_;
  std::vector<double> seconds_;
};

class Stopwatch {
 public:
  Stopwatch(CostLedger& ledger, std::size_t task)
      : ledger_(ledger), task_(task), start_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() {
    ledger_.charge(
        task_, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  CostLedger& ledger_;
  std::size_t task_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace gasgrain
