#include "tools/script_steps.h"

#include <cmath>
#include <cstdlib>

#include "coupling/base/error.h"
#include "tools/dem_script.h"

namespace gasgrain {

long last_step(const RunOptions& options) {
  try {
    auto given = options.variables;
    given.emplace_back("out", "results");
    const DemScript script(script_of(options.scene, options.host), given);
    long step = 0;
    for (const auto& command : script.commands()) {
      if (command.words.size() < 2) continue;
      if (command.words[0] == "reset_timestep") step = std::atol(command.words[1].c_str());
      if (command.words[0] != "run") continue;
      const long count = std::lround(std::strtod(command.words[1].c_str(), nullptr));
      const bool up_to = command.words.size() > 2 && command.words[2] == "upto";
      step = up_to ? count : step + count;
    }
    return step;
  } catch (const Error&) {
    return 0;  // the host reads the script itself; this is for the progress line only
  }
}

}  // namespace gasgrain
