#include "tools/calibrate/calibrate_progress.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdio>

#include "tools/progress_text.h"

namespace gasgrain {

CalibrateProgress::CalibrateProgress() : terminal_(isatty(STDOUT_FILENO) != 0) {}

void CalibrateProgress::look(const std::vector<std::string>& runs) {
  constexpr std::chrono::milliseconds redraw{500};
  constexpr std::chrono::milliseconds plain{15000};
  if (runs.empty() || Clock::now() - shown_ < (terminal_ ? redraw : plain)) return;
  shown_ = Clock::now();
  const double wall = std::chrono::duration<double>(shown_ - start_).count();
  clear();
  fmt::print("wall {}  running {}", clock_text(wall), fmt::join(runs, ", "));
  if (!terminal_) fmt::print("\n");
  std::fflush(stdout);
}

void CalibrateProgress::clear() const {
  if (terminal_) fmt::print("\r\x1b[K");
}

}  // namespace gasgrain
