// The grains of a scene, read from its DEM script.
#pragma once

#include <filesystem>

#include "tools/study/bounce.h"

namespace gasgrain {

// Of type 1, with the contact properties of type 1 on itself; where grains have several sizes, the
// first that the script names. Throws an Error that names what the script lacks.
GrainMaterial scene_material(const std::filesystem::path& scene);

}  // namespace gasgrain
