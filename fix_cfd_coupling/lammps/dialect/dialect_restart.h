// A restart file of the host, written now.
#pragma once

#include <string>

#include "write_restart.h"

namespace gasgrain {

// Collective over the DEM ranks.
inline void write_restart_file(LAMMPS_NS::LAMMPS& host, const std::string& name) {
  LAMMPS_NS::WriteRestart writer(&host);
  writer.multiproc_options(0, 0, 0, nullptr);  // one file
  writer.write(name);
}

}  // namespace gasgrain
