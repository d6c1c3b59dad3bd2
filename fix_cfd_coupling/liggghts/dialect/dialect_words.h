// How a user of this host writes what our messages tell to write.
#pragma once

namespace gasgrain::words {

constexpr const char* dem_program = "gasgrain-liggghts -in in.liggghts";
constexpr const char* sphere_style = "'atom_style granular' (or sphere)";
constexpr const char* grain_pair_style = "pair_style gran/bridge";
constexpr const char* grain_wall = "fix wall/gran";
constexpr const char* contact_models =
    "gran/bridge model hertz, hooke, hooke/stiffness, hertz/stiffness";

}  // namespace gasgrain::words
