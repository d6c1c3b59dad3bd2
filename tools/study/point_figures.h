// What one run of a study cost and gave, read from its results folder.
#pragma once

#include <filesystem>

#include "tools/study/study_point.h"

namespace gasgrain {

// Adds, from ledger.json (DEM side, the greatest of its ranks) and history.csv (gas stage):
//   wall_s_per_s        wall seconds from the couple/gas line on, coupling and waiting included, a
//                       simulated second
//   void_fraction_share, waiting_share, gas_share   shares of that time: finding and depositing
//   void
//                       fraction, waiting for the gas, all of coupling, gas and waiting
//   bed_height_m, bubble_diameter_m   means over the gas stage
//   overlap             greatest, of a diameter
//   gas_substeps        gas steps a coupling
//   clamps              how often a clamp or limiter acted (docs/liggghts.md)
void add_point_figures(const std::filesystem::path& results, Figures& figures);

}  // namespace gasgrain
