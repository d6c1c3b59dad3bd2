// How many steps a DEM script runs.
#pragma once

#include "tools/run_options.h"

namespace gasgrain {

// The step at which the scene's script ends, 0 where reading cannot tell (loops, values that only a
// run knows).
long last_step(const RunOptions& options);

}  // namespace gasgrain
