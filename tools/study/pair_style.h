// Which loop over contacts a scene's script asks for: LIGGGHTS's own, `pair_style gran`, or ours of
// the same words, `pair_style gran/bridge`.
#pragma once

#include <filesystem>
#include <string>

#include "tools/scene_copy.h"

namespace gasgrain {

constexpr const char* host_pair_style = "gran";
constexpr const char* own_pair_style = "gran/bridge";

// Ours has loops for contacts with a tangential model only.
bool own_loop_has(const std::string& contact);

// Puts the style into the copy of the scene. Throws Error when its script asks for neither.
void set_pair_style(SceneCopy& copy, const std::filesystem::path& scene, const std::string& style);

}  // namespace gasgrain
