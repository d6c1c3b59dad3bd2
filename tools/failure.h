// Why a launch failed, read from what it printed: the program's own words, without those of MPI.
#pragma once

#include <istream>
#include <string>

#include "tools/dem_host.h"

namespace gasgrain {

// `output` is what the launch printed. Ranks 0 to dem_ranks - 1 of the launch are the DEM side.
std::string failure_reason(std::istream& output, int dem_ranks, DemHost host = DemHost::liggghts);

}  // namespace gasgrain
