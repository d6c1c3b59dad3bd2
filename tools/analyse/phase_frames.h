// The frames of a run's dumps as big and small grains with their forces.
#pragma once

#include <array>
#include <string>

#include "tools/analyse/big_grains.h"
#include "tools/analyse/drag_rates.h"

namespace gasgrain {

// The three columns of the force on a grain [N].
struct ForceColumns {
  std::array<std::string, 3> names;  // empty: the dumps have none
  bool is_mean = false;              // over the steps since the last dump; else of the dumped step

  [[nodiscard]] std::string text() const;  // what the windows' means are of
};

// `wanted`: "f_mean", or "f"; empty: f_mean[1..3] where they are, else fx fy fz, else none.
ForceColumns force_columns(const DumpFrame& frame, const std::string& wanted);

Phases phases_of(const DumpFrame& frame, const BigGrains& big, const ForceColumns& force);

}  // namespace gasgrain
