#include "tools/study/study_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "tools/progress_text.h"

namespace gasgrain {

StudyProgress::StudyProgress(double expected)
    : expected_(std::max(expected, 1e-300)), terminal_(isatty(STDOUT_FILENO) != 0) {}

void StudyProgress::begin(const std::string& text, double expected, bool there_already) {
  text_ = text;
  current_ = expected;
  there_already_ = there_already;
  if (!there_already) show(0.0);
}

void StudyProgress::look(double share) {
  constexpr std::chrono::milliseconds redraw{500};
  constexpr std::chrono::milliseconds plain{5000};
  if (Clock::now() - shown_ < (terminal_ ? redraw : plain)) return;
  show(share);
}

void StudyProgress::end(const std::string& line) {
  clear_line();
  fmt::print("{}\n", line);
  std::fflush(stdout);
  done_ += current_;
  if (there_already_) skipped_ += current_;
  current_ = 0.0;
}

void StudyProgress::clear_line() const {
  if (terminal_) fmt::print("\r\x1b[K");
}

void StudyProgress::show(double share) {
  shown_ = Clock::now();
  const double wall = std::chrono::duration<double>(shown_ - start_).count();
  const double reached = done_ + share * current_;
  const double own = reached - skipped_;
  std::string line = fmt::format("{:3.0f} %  {}  {:.0f} %  wall {}", 100.0 * reached / expected_,
                                 text_, 100.0 * share, clock_text(wall));
  if (own > 0.0) line += fmt::format("  left {}", clock_text(wall * (expected_ - reached) / own));
  if (terminal_) {
    constexpr std::size_t width = 20;
    const auto filled = static_cast<std::size_t>(std::clamp(reached / expected_, 0.0, 1.0) * width);
    clear_line();
    fmt::print("[{:.<{}}] {}", std::string(filled, '#'), width, line);
  } else {
    fmt::print("{}\n", line);
  }
  std::fflush(stdout);
}

}  // namespace gasgrain
