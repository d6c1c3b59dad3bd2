// Shows how far a run is: a line redrawn in place on a terminal, a plain line now and then else.
#pragma once

#include <chrono>

#include "tools/history.h"
#include "tools/progress_text.h"

namespace gasgrain {

class Progress {
 public:
  // Made before the launch: what an earlier run left in the folder is not taken for news.
  explicit Progress(const std::filesystem::path& results);

  // Looks at the files and shows what is new, when it is time to.
  void update();
  // Ends the line drawn in place, so that other text can follow.
  void end_line();
  [[nodiscard]] double wall_s() const;

 private:
  [[nodiscard]] std::optional<ProgressState> state();
  void show(const std::optional<ProgressState>& state);

  using Clock = std::chrono::steady_clock;
  std::filesystem::path plan_file_;
  std::filesystem::file_time_type plan_time_;
  std::optional<RunPlan> plan_;
  History history_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  // Where the present stage was first seen: the time left is reckoned from its own pace.
  std::optional<bool> stage_packing_;
  double stage_time_s_ = 0.0;
  double stage_wall_s_ = 0.0;
};

}  // namespace gasgrain
