// A restart file of the host, written now.
#pragma once

#include <string>

#include "write_restart.h"

namespace gasgrain {

// Collective over the DEM ranks.
inline void write_restart_file(LAMMPS_NS::LAMMPS& host, std::string name) {
  LAMMPS_NS::WriteRestart(&host).write(name.data());
}

}  // namespace gasgrain
