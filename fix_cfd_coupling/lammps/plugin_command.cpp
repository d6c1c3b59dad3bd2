#include "fix_cfd_coupling/lammps/plugin_command.h"

#include <string>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/law_library.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "command.h"
#include "input.h"

namespace gasgrain {
namespace {

class PluginCommand : public LAMMPS_NS::Command {
 public:
  using Command::Command;

  void command(int count, char** words) override {
    try {
      if (count != 2 || std::string(words[0]) != "load")
        fail("the command is 'plugin load FILE', FILE a library made by gasgrain_add_law(LAW.h).{}",
             count > 0 && std::string(words[0]) != "load" ? suggestion(words[0], {"load"}) : "");
      contact::load_law(words[1], "lammps");
    } catch (const Error& e) {
      stop_everything(e.what());
    }
  }
};

}  // namespace

void add_plugin_command(LAMMPS_NS::LAMMPS& host) {
  host.input->command_map->emplace(
      "plugin", [](LAMMPS_NS::LAMMPS* of) -> LAMMPS_NS::Command* { return new PluginCommand(of); });
}

}  // namespace gasgrain
