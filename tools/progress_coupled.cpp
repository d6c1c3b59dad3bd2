// How far a coupled run is, from run.json (its plan) and history.csv (its course).
#include <algorithm>
#include <memory>

#include "tools/history.h"
#include "tools/progress.h"
#include "tools/progress_text.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

fs::file_time_type time_of(const fs::path& file) {
  std::error_code absent;
  const auto time = fs::last_write_time(file, absent);
  return absent ? fs::file_time_type::min() : time;
}

class CoupledRun {
 public:
  explicit CoupledRun(const fs::path& results)
      : plan_file_(results / "run.json"),
        plan_time_(time_of(plan_file_)),
        history_(results / "history.csv") {
    history_.read_on();
    history_.forget_rows();
  }

  std::optional<ProgressState> state(double wall_s) {
    // A scene of several runs writes its plan at the start of each.
    if (const auto written = time_of(plan_file_); written != plan_time_) {
      plan_ = read_run_plan(plan_file_);
      plan_time_ = written;
    }
    if (!plan_) return std::nullopt;
    history_.read_on();
    const auto time = history_.last("time_s");
    if (!time) return std::nullopt;

    ProgressState now;
    now.packing = *time < 0.0;
    now.start_s = now.packing ? plan_->first_s() : std::max(0.0, plan_->first_s());
    now.time_s = *time;
    now.end_s = now.packing ? std::min(0.0, plan_->time_end_s) : plan_->time_end_s;
    now.wall_s = wall_s;
    now.bed_height_m = history_.last("bed_height_m");
    now.max_overlap = history_.last("max_overlap");
    now.courant = history_.last("courant");
    if (stage_packing_ != now.packing) {
      stage_packing_ = now.packing;
      stage_time_s_ = now.time_s;
      stage_wall_s_ = now.wall_s;
    }
    if (now.time_s > stage_time_s_)
      now.left_s =
          (now.end_s - now.time_s) * (now.wall_s - stage_wall_s_) / (now.time_s - stage_time_s_);
    return now;
  }

 private:
  fs::path plan_file_;
  fs::file_time_type plan_time_;
  std::optional<RunPlan> plan_;
  History history_;
  // Where the present stage was first seen: the time left is reckoned from its own pace.
  std::optional<bool> stage_packing_;
  double stage_time_s_ = 0.0;
  double stage_wall_s_ = 0.0;
};

}  // namespace

Progress::Text coupled_progress(const fs::path& results) {
  return [run = std::make_shared<CoupledRun>(results)](double wall_s, std::size_t width, bool bar) {
    const auto state = run->state(wall_s);
    return state ? progress_text(*state, width, bar) : std::string();
  };
}

}  // namespace gasgrain
