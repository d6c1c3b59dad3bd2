// What `gasgrain analyse` leaves: solid_drag_windows.csv, a row a window, big grain and cube;
// solid_drag.csv, the steady means; solid_drag.json, what the picture needs beside them.
#pragma once

#include <filesystem>

#include "tools/analyse/steady_drag.h"

namespace gasgrain {

struct DragLabels {
  std::string command;
  std::string force;  // how the force is a mean
  double window_s = 0.0;
  std::array<double, 2> steady_s{};
};

void write_drag(const std::filesystem::path& folder, const std::vector<DragRate>& rates,
                const std::vector<SteadyDrag>& means, const DragLabels& labels);

// The steady means, for the screen.
std::string text_of(const std::vector<SteadyDrag>& means);

}  // namespace gasgrain
