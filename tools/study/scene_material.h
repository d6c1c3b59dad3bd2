// The grains of a scene, read from its DEM script.
#pragma once

#include <filesystem>

#include "tools/study/bounce.h"

namespace gasgrain {

// Of the largest grains; of several types the contacts that advise_scene.h takes. Throws an Error
// that names what the script lacks.
GrainMaterial scene_material(const std::filesystem::path& scene);

}  // namespace gasgrain
