// Before a run: is the DEM step fit for the stiffness of the contacts that the script sets?
//
// Reads what the host's own contact models read: youngsModulus, poissonsRatio,
// coefficientRestitution, characteristicVelocity, kn of the property/global fixes, the normal model
// of the pair style, and the smallest grain of each type. The times are those of
// dem_physics/contact_time.h, the limits those of dem_physics/contact_step.h.
//
// Hertz's contact takes a speed: that of a free fall through the box, or of the fastest grain when
// that is more. The duration goes with speed^(-1/5), so that a factor of 2 is 13 %.
#pragma once

#include <string>

#include "coupling/base/communicator.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

struct ContactVerdict {
  bool had_grains = false;  // without grains there is nothing to judge yet
  std::string refusal;      // the step is too long: why, and what to write; empty: it is not
  std::string warning;      // it is long, or the contacts could not be read
};

// Collective over the DEM ranks; the same on all of them. After the host's init().
ContactVerdict judge_contacts(LAMMPS_NS::LAMMPS& host, const Communicator& local);

}  // namespace gasgrain
