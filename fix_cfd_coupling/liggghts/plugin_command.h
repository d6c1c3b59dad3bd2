// The script's command `plugin load FILE`: adds a contact law that was built elsewhere
// (dem_physics/contact/law_library.h). The word is that of LAMMPS, which loads the same law's other
// library with it.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

void plugin_command(LAMMPS_NS::LAMMPS* host, int count, char** words);

}  // namespace gasgrain
