// The dials of a scene: the variables of style index of its script, which a run may set.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gasgrain {

// Name and value of each `variable NAME index VALUE` of in.liggghts.
std::map<std::string, std::string> scene_dials(const std::filesystem::path& scene);

// One text that tells two states of a scene apart: all its files.
std::string scene_state(const std::filesystem::path& scene);

}  // namespace gasgrain
