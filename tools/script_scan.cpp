#include "tools/script_scan.h"

#include <fstream>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

namespace fs = std::filesystem;

ScriptScan::ScriptScan(const fs::path& script) {
  read(script, 0);
}

void ScriptScan::read(const fs::path& script, int depth) {
  constexpr int deepest = 8;  // a script may include itself
  std::ifstream file(script);
  int number = 0;
  std::string command;
  for (std::string line; depth < deepest && std::getline(file, line);) {
    ++number;
    command += line.substr(0, line.find('#'));
    const auto last = command.find_last_not_of(" \t\r");
    if (last != std::string::npos && command[last] == '&') {
      command.replace(last, std::string::npos, " ");
      continue;
    }
    take(command, fmt::format("{}:{}", script.string(), number), script.parent_path(), depth);
    command.clear();
  }
}

void ScriptScan::take(const std::string& command, const std::string& place, const fs::path& folder,
                      int depth) {
  std::istringstream words(command);
  std::string verb;
  std::string id;
  std::string third;
  std::string style;
  words >> verb >> id >> third >> style;
  if (verb == "include") read(folder / id, depth + 1);
  if (verb == "variable" && third == "index") index_names.push_back(id);
  if (verb != "fix") return;
  if (style == coupling_style) couples = true;
  if (style.rfind("couple/", 0) == 0 && style != coupling_style &&
      !nearest_name(style, {coupling_style}).empty())
    misspelt.push_back(fmt::format("{}: fix style \"{}\" is unknown.{}", place, style,
                                   suggestion(style, {coupling_style})));
}

bool is_without_gas(const fs::path& scene, DemHost host) {
  const fs::path script = script_of(scene, host);
  if (fs::exists(scene / "gas.toml") || !fs::is_regular_file(script)) return false;
  const ScriptScan scan(script);
  return !scan.couples && scan.misspelt.empty();
}

}  // namespace gasgrain
