// What a launch needs to know of a DEM script and the files it includes, read line by line without
// following its course: the coupling to the gas and the variables that a command line may set.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/dem_host.h"

namespace gasgrain {

struct ScriptScan {
  explicit ScriptScan(const std::filesystem::path& script);

  bool couples = false;                  // has a `fix ID all couple/gas`
  std::vector<std::string> misspelt;     // messages: styles that were meant to be it
  std::vector<std::string> index_names;  // of `variable NAME index VALUE`

  static constexpr const char* coupling_style = "couple/gas";

 private:
  void read(const std::filesystem::path& script, int depth);
  void take(const std::string& command, const std::string& place,
            const std::filesystem::path& folder, int depth);
};

// Whether a folder holds a scene of grains alone: a script that couples to no gas, and no gas.toml.
bool is_without_gas(const std::filesystem::path& scene, DemHost host);

}  // namespace gasgrain
