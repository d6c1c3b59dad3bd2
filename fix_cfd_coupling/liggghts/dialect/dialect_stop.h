// The orderly end of a run before its last step.
#pragma once

#include "lammps.h"
// --
#include "signal_handling.h"

namespace gasgrain {

// The host ends this run after the step, and makes no further one. On all DEM ranks.
inline void end_runs(LAMMPS_NS::LAMMPS&) {
  LAMMPS_NS::SignalHandler::request_quit = true;
}

}  // namespace gasgrain
