// How far a grain may leave the sub-domain of its rank, before it is handed on.
#pragma once

#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"

namespace gasgrain {

inline double drift_of_grains(LAMMPS_NS::LAMMPS& host) {  // [m]
  return NeighborSorted::of(host).drift();
}

}  // namespace gasgrain
