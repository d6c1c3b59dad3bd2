// Shows how far a run is: a line redrawn in place on a terminal, a plain line now and then else.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace gasgrain {

class Progress {
 public:
  // The line's text for a wall time [s], a width, and with or without a bar; empty when there is
  // nothing to tell yet.
  using Text = std::function<std::string(double wall_s, std::size_t width, bool bar)>;
  explicit Progress(Text text);

  // Shows what is new, when it is time to.
  void update();
  // Ends the line drawn in place, so that other text can follow.
  void end_line();
  [[nodiscard]] double wall_s() const;

 private:
  void show(const std::string& text);

  using Clock = std::chrono::steady_clock;
  Text text_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

// Of a coupled run, from run.json and history.csv. Made before the launch: what an earlier run left
// in the folder is not taken for news.
Progress::Text coupled_progress(const std::filesystem::path& results);

// Of a run of grains alone, from the thermo lines in `log`, against the steps of the script's runs
// where they can be told.
Progress::Text grains_progress(const std::filesystem::path& log, long last_step);

}  // namespace gasgrain
