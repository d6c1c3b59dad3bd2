// LIGGGHTS's arrays of this rank's grains and ghosts as a loop over contacts reads them.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/contact_arrays.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// For spheres of atom_style granular or sphere. Without frozen grains and rigid bodies; the history
// may change.
contact::Grains grains_of(const LAMMPS_NS::LAMMPS& host);

}  // namespace gasgrain
