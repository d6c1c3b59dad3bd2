// The script's command `plugin load FILE`: adds a contact law that was built elsewhere
// (dem_physics/contact/law_library.h). For a LAMMPS without the PLUGIN package, whose own command
// of this name calls the same library's lammpsplugin_init().
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// Leaves the host's own command where it has one.
void add_plugin_command(LAMMPS_NS::LAMMPS& host);

}  // namespace gasgrain
