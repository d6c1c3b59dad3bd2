// Whether a scene can run, found out before anything is started.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/programs.h"
#include "tools/run_options.h"

namespace gasgrain {

// Every fault of the scene and of the request, a text each; empty when the run can start.
std::vector<std::string> scene_faults(const RunOptions& options, const Programs& programs);

// Throws Error, with the nearest name, when there is no such folder.
void require_scene(const std::filesystem::path& scene);

}  // namespace gasgrain
