#include "tools/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tools/progress_text.h"

namespace gasgrain {

namespace {

std::size_t terminal_width() {
  constexpr std::size_t usual = 100;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col - 1U;  // a full last column would wrap
}

}  // namespace

Progress::Progress(Text text) : text_(std::move(text)), terminal_(isatty(STDOUT_FILENO) != 0) {}

double Progress::wall_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update() {
  constexpr std::chrono::milliseconds redraw{500};
  constexpr std::chrono::milliseconds plain{5000};
  if (Clock::now() - shown_ < (terminal_ ? redraw : plain)) return;
  shown_ = Clock::now();
  constexpr std::size_t no_limit = 1000;
  const std::string text = text_(wall_s(), terminal_ ? terminal_width() : no_limit, terminal_);
  show(text.empty() ? fmt::format("starting  wall {}", clock_text(wall_s())) : text);
}

void Progress::show(const std::string& text) {
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
