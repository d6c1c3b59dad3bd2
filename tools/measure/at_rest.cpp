#include "tools/measure/at_rest.h"

#include <cmath>

#include "coupling/base/error.h"

namespace gasgrain {

std::string motion_note(const DumpFrame& frame, double floor) {
  constexpr double gravity = 9.81;
  constexpr double slow = 0.1;  // of sqrt(g d)
  constexpr double few = 0.02;  // of the grains: the last that roll off
  const std::size_t z = frame.column("z");
  const std::size_t radius = frame.column("radius");
  const std::size_t v[] = {frame.column("vx"), frame.column("vy"), frame.column("vz")};
  int all = 0;
  int moving = 0;
  for (std::size_t n = 0; n < frame.size(); ++n) {
    if (frame.value(n, z) <= floor) continue;
    ++all;
    const double speed =
        std::hypot(frame.value(n, v[0]), frame.value(n, v[1]), frame.value(n, v[2]));
    if (speed > slow * std::sqrt(2.0 * gravity * frame.value(n, radius))) ++moving;
  }
  if (moving <= few * all) return "";
  return fmt::format(
      "{} of {} grains still move at the end of the run: give them longer to come to rest.", moving,
      all);
}

}  // namespace gasgrain
