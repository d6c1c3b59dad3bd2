// What the script says of the grains' contacts. Nothing of it can be read from LAMMPS's own styles.
#pragma once

#include <string>

#include "fix.h"

namespace gasgrain {

inline LAMMPS_NS::Fix* find_material(LAMMPS_NS::LAMMPS&, const char*, const char*) {
  return nullptr;
}
template <class Names>
std::string normal_model_among(LAMMPS_NS::LAMMPS&, const Names&) {
  return "";
}

}  // namespace gasgrain
