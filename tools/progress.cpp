#include "tools/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

fs::file_time_type time_of(const fs::path& file) {
  std::error_code absent;
  const auto time = fs::last_write_time(file, absent);
  return absent ? fs::file_time_type::min() : time;
}

std::size_t terminal_width() {
  constexpr std::size_t usual = 100;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col - 1U;  // a full last column would wrap
}

}  // namespace

Progress::Progress(const fs::path& results)
    : plan_file_(results / "run.json"),
      plan_time_(time_of(plan_file_)),
      history_(results / "history.csv"),
      terminal_(isatty(STDOUT_FILENO) != 0) {
  history_.read_on();
  history_.forget_rows();
}

double Progress::wall_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update() {
  constexpr std::chrono::milliseconds redraw{500};
  constexpr std::chrono::milliseconds plain{5000};
  if (Clock::now() - shown_ < (terminal_ ? redraw : plain)) return;
  shown_ = Clock::now();
  show(state());
}

std::optional<ProgressState> Progress::state() {
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
  now.wall_s = wall_s();
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

void Progress::show(const std::optional<ProgressState>& state) {
  constexpr std::size_t no_limit = 1000;
  const std::string text =
      state ? progress_text(*state, terminal_ ? terminal_width() : no_limit, terminal_)
            : fmt::format("starting  wall {}", clock_text(wall_s()));
  if (terminal_)
    fmt::print("\r{}\x1b[K", text);  // the sequence clears the rest of the line
  else
    fmt::print("{}\n", text);
  line_open_ = terminal_;
  std::fflush(stdout);
}

void Progress::end_line() {
  if (line_open_) fmt::print("\n");
  line_open_ = false;
  std::fflush(stdout);
}

}  // namespace gasgrain
