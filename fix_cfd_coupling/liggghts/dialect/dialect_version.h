// The host's name and version, for the record of a run.
#pragma once

#include <string>

#include "universe.h"

namespace gasgrain {

inline std::string host_version(LAMMPS_NS::LAMMPS& host) {
  return host.universe->version;
}

}  // namespace gasgrain
