// The one mpirun command that starts both sides of a run, or the DEM side of a scene without gas.
#pragma once

#include <optional>

#include "tools/child_process.h"
#include "tools/programs.h"
#include "tools/run_options.h"

namespace gasgrain {

// As asked for; a scene of grains alone, which is small, has one rank where none is named.
int dem_ranks(const RunOptions& options);

// `results` is absolute; `restart_step` names the checkpoint to go on from.
Command launch_command(const RunOptions& options, const Programs& programs,
                       const std::filesystem::path& results, std::optional<long> restart_step);

// The `gasgrain run` line that goes on from the last checkpoint of this run.
std::string restart_line(const RunOptions& options);

}  // namespace gasgrain
