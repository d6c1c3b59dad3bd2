// The host's arrays of this rank's grains and ghosts as the loops over contacts take them.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/contact_arrays.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// For spheres. `frozen`: bit of the group of `fix freeze`, or 0; `body_mass`: of the rigid bodies
// of grains, or null. The history may change, but not while a run is set up.
contact::Grains grains_of(const LAMMPS_NS::LAMMPS& host, int frozen, const double* body_mass);

}  // namespace gasgrain
