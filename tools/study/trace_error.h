// How far one run's course is from another's.
#pragma once

#include <filesystem>

#include "tools/study/study_point.h"

namespace gasgrain {

// Adds to the figures, from both runs' history.csv over the gas time that both have:
//   height_error    rms difference of the bed height over the reference's mean bed height
//   bubble_error    difference of the mean bubble diameters over the reference's
//   energy_error    rms difference of the grains' kinetic energy over the reference's rms
//   pressure_error  rms difference of the lowest probe's pressure over the reference's rms; only
//                   where the scene has a probe
// The reference is interpolated linearly in time. Where it is 0 throughout, the figure is left out.
void add_trace_errors(const std::filesystem::path& history, const std::filesystem::path& reference,
                      Figures& figures);

}  // namespace gasgrain
