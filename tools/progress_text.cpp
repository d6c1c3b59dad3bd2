#include "tools/progress_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gasgrain {

double ProgressState::fraction() const {
  return end_s > start_s ? std::clamp((time_s - start_s) / (end_s - start_s), 0.0, 1.0) : 1.0;
}

std::string clock_text(double seconds) {
  const long s = std::lround(std::max(0.0, seconds));
  constexpr long minute = 60;
  constexpr long hour = 3600;
  return fmt::format("{}:{:02}:{:02}", s / hour, s / minute % minute, s % minute);
}

std::string progress_text(const ProgressState& state, std::size_t width, bool bar) {
  constexpr std::size_t bar_width = 20;
  const auto filled = static_cast<std::size_t>(state.fraction() * bar_width);
  std::string line;
  if (bar) line = fmt::format("[{:.<{}}] ", std::string(filled, '#'), bar_width);
  line += state.packing ? fmt::format("packing {:.3f} s", state.time_s)
                        : fmt::format("{:.3f} of {:.3f} s", state.time_s, state.end_s);

  std::vector<std::string> items{fmt::format("wall {}", clock_text(state.wall_s))};
  if (state.left_s)
    items.push_back(
        fmt::format("left {}{}", clock_text(*state.left_s), state.packing ? " of packing" : ""));
  if (state.bed_height_m) items.push_back(fmt::format("bed {:.4f} m", *state.bed_height_m));
  if (state.max_overlap)
    items.push_back(fmt::format("overlap {:.2g} %", 100.0 * *state.max_overlap));
  if (state.courant) items.push_back(fmt::format("Courant {:.2f}", *state.courant));
  for (const auto& item : items) {
    if (line.size() + 2 + item.size() > width) break;
    line += "  " + item;
  }
  return line.substr(0, width);
}

}  // namespace gasgrain
