// How far a grain may leave the sub-domain of its rank, before it is handed on.
#pragma once

#include "lammps.h"
// --
#include "neighbor.h"

namespace gasgrain {

// It is handed on when lists are made anew, before it has moved half the skin.
inline double drift_of_grains(LAMMPS_NS::LAMMPS& host) {  // [m]
  return host.neighbor->skin;
}

}  // namespace gasgrain
