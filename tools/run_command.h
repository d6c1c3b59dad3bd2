// `gasgrain run`: checks a scene, launches both sides, watches them, and tells how it went.
#pragma once

#include "tools/run_options.h"

namespace gasgrain {

// The exit status for the shell. Throws Error when the run cannot start.
int run(const RunOptions& options);

}  // namespace gasgrain
