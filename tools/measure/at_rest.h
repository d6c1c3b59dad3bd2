// Whether grains have come to rest: an angle of repose is one of grains at rest.
#pragma once

#include <string>

#include "tools/measure/dump_file.h"

namespace gasgrain {

// A sentence for the notes where more than 2 % of the grains above `floor` [m] are faster than a
// tenth of sqrt(g d), the speed of a fall through half their diameter; else empty. The frame needs
// the columns z, vx, vy, vz, radius.
std::string motion_note(const DumpFrame& frame, double floor);

}  // namespace gasgrain
