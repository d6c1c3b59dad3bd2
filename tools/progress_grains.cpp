// How far a run of grains alone is, from what the host prints.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "tools/progress.h"
#include "tools/progress_text.h"

namespace gasgrain {

namespace {

// The last thermo line's first word, while the table's heading begins with Step.
long last_thermo_step(const std::filesystem::path& log) {
  std::ifstream stream(log);
  long step = 0;
  bool in_table = false;
  for (std::string line; std::getline(stream, line);) {
    const auto begin = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(begin, 5, "Step ") == 0) in_table = true;
    if (line.compare(begin, 9, "Loop time") == 0) in_table = false;
    if (in_table && begin < line.size() &&
        std::isdigit(static_cast<unsigned char>(line[begin])) != 0)
      step = std::atol(line.c_str() + begin);
  }
  return step;
}

}  // namespace

Progress::Text grains_progress(const std::filesystem::path& log, long last_step) {
  return [log, last_step](double wall_s, std::size_t width, bool bar) {
    const long step = last_thermo_step(log);
    if (step == 0) return std::string();
    std::string line = fmt::format("step {}", step);
    if (last_step >= step) {
      const double share = static_cast<double>(step) / static_cast<double>(last_step);
      constexpr std::size_t bar_width = 20;
      const auto filled = static_cast<std::size_t>(share * bar_width);
      line = (bar ? fmt::format("[{:.<{}}] ", std::string(filled, '#'), bar_width) : "") + line +
             fmt::format(" of {}  wall {}  left {}", last_step, clock_text(wall_s),
                         clock_text(wall_s * (1.0 / share - 1.0)));
    } else {
      line += fmt::format("  wall {}", clock_text(wall_s));
    }
    return line.substr(0, width);
  };
}

}  // namespace gasgrain
