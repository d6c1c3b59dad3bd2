// The script's walls that grains touch.
#pragma once

#include <set>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// Of the materials of all walls that are known here.
inline std::set<int> wall_types(LAMMPS_NS::LAMMPS&) {
  return {};
}

}  // namespace gasgrain
