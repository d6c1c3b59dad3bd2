// `gasgrain calibrate SCENE`: the values of a scene's dials at which it gives what was measured.
#pragma once

#include "tools/calibrate/calibrate_options.h"

namespace gasgrain {

// The exit status: 0 when every target is met within its tolerance, 2 when they cannot be or were
// not, 130 after Ctrl-C. Throws Error when nothing can be run or a run fails.
int calibrate(const CalibrateOptions& options);

}  // namespace gasgrain
