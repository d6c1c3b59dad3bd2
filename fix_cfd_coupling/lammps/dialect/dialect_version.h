// The host's name and version, for the record of a run.
#pragma once

#include <string>

#include "lammps.h"

namespace gasgrain {

inline std::string host_version(LAMMPS_NS::LAMMPS& host) {
  return std::string("LAMMPS ") + host.version;
}

}  // namespace gasgrain
