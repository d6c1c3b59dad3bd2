#include "gas_solver/io/progress.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace gasgrain {
namespace {

constexpr double seconds_until_bar = 5;

std::string line_text(const GasReport& report, double end) {
  return fmt::format(
      "t = {:.6g} of {:.6g} s, {} steps of {:.3g} s, Courant number {:.3g}, inflow {:.6g}, "
      "outflow {:.6g} kg/s",
      report.time, end, report.substeps, report.step, report.courant_max, report.mass_inflow,
      report.mass_outflow);
}

}  // namespace

bool output_on_terminal() {
  if (isatty(STDOUT_FILENO) == 0) return false;
  if (std::getenv("OMPI_COMM_WORLD_LOCAL_RANK") == nullptr) return true;
  const std::string of_parent = fmt::format("/proc/{}/fd/{}", getppid(), STDOUT_FILENO);
  const int output = open(of_parent.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (output < 0) return false;
  const bool terminal = isatty(output) != 0;
  close(output);
  return terminal;
}

std::string bar_text(double fraction, double time, double end, double left_s) {
  constexpr double width = 30;
  constexpr long minute = 60;
  constexpr long hour = 3600;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const long left = std::lround(std::max(0.0, left_s));
  return fmt::format("[{:.<{}}] {:3.0f} %  {:.6g} of {:.6g} s  left {}:{:02}:{:02}",
                     std::string(static_cast<std::size_t>(part * width), '#'),
                     static_cast<int>(width), std::floor(100 * part), time, end, left / hour,
                     left / minute % minute, left % minute);
}

RunProgress::RunProgress(double begin, double end, bool on_terminal)
    : begin_(begin), end_(end), on_terminal_(on_terminal) {}

void RunProgress::show(const GasReport& report) {
  const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
  const double done = report.time - begin_;
  const double left = (end_ - report.time) * wall / done;
  if (!on_terminal_)
    fmt::print("{}\n", line_text(report, end_));
  else if (wall > seconds_until_bar)
    fmt::print("\r\033[K{}  Courant number {:.3g}",
               bar_text(done / (end_ - begin_), report.time, end_, left), report.courant_max);
  else
    fmt::print("\r\033[K{}", line_text(report, end_));
  line_open_ = on_terminal_;
  std::fflush(stdout);
}

void RunProgress::tell(const std::string& text) {
  finish();
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

void RunProgress::finish() {
  if (line_open_) fmt::print("\n");
  line_open_ = false;
  std::fflush(stdout);
}

SubstepNote::SubstepNote(const GasInput& input, double time) : step_(input.step), time_(time) {}

std::string SubstepNote::after(const GasReport& report) {
  const double interval = report.time - time_;
  time_ = report.time;
  constexpr double round_off = 1e-6;
  const double asked = std::ceil(interval / step_ * (1 - round_off));
  if (told_ || report.substeps <= asked) return "";
  told_ = true;
  const double longest = interval / asked;
  return fmt::format(
      "note: at t = {:.6g} s the gas takes {} steps of {:.3g} s in an interval of {:.3g} s: with "
      "{:.3g} s the Courant number would be {:.3g}.",
      report.time, report.substeps, report.step, interval, longest,
      report.courant_max * longest / report.step);
}

}  // namespace gasgrain
