// `gasgrain analyse`: the drag between big and small grains, from the dumps of a run.
#pragma once

#include "tools/analyse/analyse_options.h"

namespace gasgrain {

// Returns the exit status; throws Error, all faults of the command line in one.
int analyse(const AnalyseOptions& options);

}  // namespace gasgrain
