// Means over the steady period of an encounter, a row a size of cube.
#pragma once

#include <array>
#include <vector>

#include "tools/analyse/drag_rates.h"

namespace gasgrain {

// [from, to] in s. Without forces the whole run; else the middle half of the encounter, which lasts
// from the first window to the last with a tenth of the greatest force of a window.
std::array<double, 2> steady_period(const std::vector<DragRate>& rates, double window_s);

struct SteadyDrag {
  double size = 0.0;  // of the cube, in d_s + d_b
  double side = 0.0;  // m
  int windows = 0;    // of all big grains
  double alpha_s = 0.0;
  double alpha_b = 0.0;
  double slip = 0.0;             // m/s
  double dem = 0.0;              // N/m3, along the mean of Syamlal's
  double syamlal = 0.0;          // N/m3
  double omega = 0.0;            // dem over syamlal; NaN where there is no force or no drag
  double omega_error = 0.0;      // standard error, of the windows' omegas in four blocks
  double omega_transient = 0.0;  // the greatest of a window before the steady period; NaN: none
};

// The transient's windows count from a tenth of the steady period's mean force on. Throws when the
// period has no window.
std::vector<SteadyDrag> steady_drag(const std::vector<DragRate>& rates,
                                    const std::array<double, 2>& period);

}  // namespace gasgrain
