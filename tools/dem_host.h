// The DEM programs that a scene may be written for: a script each, in the scene's folder.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

enum class DemHost { liggghts, lammps };

inline const char* script_name(DemHost host) {
  return host == DemHost::lammps ? "in.lammps" : "in.liggghts";
}

// Of the program, as messages name it.
inline const char* program_name(DemHost host) {
  return host == DemHost::lammps ? "lmp" : "gasgrain-liggghts";
}

inline std::filesystem::path script_of(const std::filesystem::path& scene, DemHost host) {
  return scene / script_name(host);
}

}  // namespace gasgrain
