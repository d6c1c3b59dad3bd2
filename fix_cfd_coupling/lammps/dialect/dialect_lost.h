// What the script wants of grains that leave the box: `thermo_modify lost`.
#pragma once

#include "output.h"
#include "thermo.h"

namespace gasgrain {

// error (true), or ignore, warn: grains may leave the box.
inline bool lost_grains_are_errors(LAMMPS_NS::LAMMPS& host) {
  const LAMMPS_NS::Thermo* thermo = host.output->thermo;
  return thermo != nullptr && thermo->lostflag == LAMMPS_NS::Thermo::ERROR;
}

}  // namespace gasgrain
