#include "fix_cfd_coupling/liggghts/plugin_command.h"

#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/law_library.h"
#include "fix_cfd_coupling/fixes/host_error.h"

namespace gasgrain {

void plugin_command(LAMMPS_NS::LAMMPS*, int count, char** words) {
  try {
    if (count != 2 || std::string(words[0]) != "load")
      fail("the command is 'plugin load FILE', FILE a library made by gasgrain_add_law(LAW.h).{}",
           count > 0 && std::string(words[0]) != "load" ? suggestion(words[0], {"load"}) : "");
    contact::load_law(words[1], "liggghts");
  } catch (const Error& error) {
    stop_everything(error.what());
  }
}

}  // namespace gasgrain
