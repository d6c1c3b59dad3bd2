// The orderly end of a run before its last step.
#pragma once

#include "lammps.h"
// --
#include "timer.h"

namespace gasgrain {

// The host ends this run after the step, and makes no further one. On all DEM ranks.
inline void end_runs(LAMMPS_NS::LAMMPS& host) {
  host.timer->force_timeout();
}

}  // namespace gasgrain
