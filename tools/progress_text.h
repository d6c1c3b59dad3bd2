// How far a run is, as one line of text.
#pragma once

#include <optional>
#include <string>

namespace gasgrain {

struct ProgressState {
  bool packing = false;  // before the gas starts, at time 0
  double start_s = 0.0;  // where this launch took the stage up
  double time_s = 0.0;
  double end_s = 0.0;  // of the stage
  double wall_s = 0.0;
  std::optional<double> left_s;  // wall time
  std::optional<double> bed_height_m;
  std::optional<double> max_overlap;  // of a diameter
  std::optional<double> courant;

  // Of the stage, from 0 to 1.
  [[nodiscard]] double fraction() const;
};

// h:mm:ss
std::string clock_text(double seconds);

// A line that fits into `width` characters: what matters least, at its end, is left out. Without
// `bar` there is no bar at its front.
std::string progress_text(const ProgressState& state, std::size_t width, bool bar);

}  // namespace gasgrain
