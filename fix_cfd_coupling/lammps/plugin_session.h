// The plugin's place in the launch of its host, and how it ends with it.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// Once per process, when the plugin is loaded: joins the partner of the launch, if there is one,
// and sees to it that the partner ends when the host does. Collective over all ranks of the launch.
void begin_session(LAMMPS_NS::LAMMPS& host);

}  // namespace gasgrain
