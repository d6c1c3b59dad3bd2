// Seconds by task: what a run spends its wall time on. A task is a name; a Stopwatch charges the
// time of its scope to it. At the end close() names the rest, so that the tasks sum to the whole.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "coupling/base/communicator.h"

namespace gasgrain {

// A clock that began when it was made.
class WallClock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// A ledger over the ranks of a group.
struct CostSummary {
  struct Cost {
    std::string task;
    double mean_s = 0.0;
    double max_s = 0.0;
  };
  int ranks = 1;
  std::vector<Cost> costs;

  // {"ranks": n, "tasks": {"name": {"mean_s": .., "max_s": ..}, ...}}
  [[nodiscard]] std::string json() const;
  // Lines of a table, the dearest task first, with each one's share of the total.
  [[nodiscard]] std::string table(const std::string& side) const;
};

class CostLedger {
 public:
  // Slot of a task, made when it is new. Ask once, outside of loops.
  std::size_t task(const std::string& name);
  void charge(std::size_t task, double seconds) { seconds_[task] += seconds; }
  [[nodiscard]] double seconds(const std::string& name) const;
  // Since the ledger was made.
  [[nodiscard]] double age() const { return clock_.seconds(); }

  // The task that all others are parts of, where somebody times the whole.
  static constexpr const char* total = "total";
  // What close() charges with the rest.
  static constexpr const char* other = "other";
  // Tasks of the DEM side that a run without gas would not have begin with this.
  static constexpr const char* coupling_prefix = "coupling:";
  // Seconds of all tasks but the total.
  [[nodiscard]] double named() const;
  // Seconds of the total that no other task has been charged with.
  [[nodiscard]] double unnamed() const { return seconds(total) - named(); }
  // The end: the total is the ledger's age, and what of it has no name is the task `other`.
  void close();

  // Mean and greatest over the ranks of a group. Collective; every rank must have made the same
  // tasks in the same order.
  [[nodiscard]] CostSummary over(const Communicator& comm) const;

 private:
  WallClock clock_;
  std::vector<std::string> names_;
  std::vector<double> seconds_;
};

// The text of ledger.json: an object with a member for each side, {side's name, its json()}.
std::string ledger_json(const std::vector<std::pair<std::string, std::string>>& sides);

class Stopwatch {
 public:
  Stopwatch(CostLedger& ledger, std::size_t task) : ledger_(ledger), task_(task) {}
  ~Stopwatch() { ledger_.charge(task_, clock_.seconds()); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  CostLedger& ledger_;
  std::size_t task_;
  WallClock clock_;
};

}  // namespace gasgrain
