#include "tools/study/pair_style.h"

#include "coupling/base/error.h"
#include "tools/dem_script.h"
#include "tools/script_edit.h"

namespace gasgrain {

bool own_loop_has(const std::string& contact) {
  return contact.find("tangential history") != std::string::npos ||
         contact.find("tangential no_history") != std::string::npos;
}

void set_pair_style(SceneCopy& copy, const std::filesystem::path& scene, const std::string& style) {
  ScriptEdit edit(copy);
  bool found = false;
  const DemScript script(scene / "in.liggghts");
  for (const ScriptCommand& command : script.commands()) {
    if (command.words.size() < 2 || command.words[0] != "pair_style") continue;
    if (command.words[1] != host_pair_style && command.words[1] != own_pair_style) continue;
    found = command.words[1] == style ||
            edit.put(command, raw_after(command, "pair_style"), style) || found;
  }
  if (!found)
    fail("{}: no line 'pair_style {} model ...' (or {}) of its own: the style cannot be changed.",
         copy.script_path(), own_pair_style, host_pair_style);
}

}  // namespace gasgrain
