#include "tools/programs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

fs::path on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && is_executable(fs::path(folder) / name)) return fs::path(folder) / name;
  return {};
}

}  // namespace

bool is_executable(const fs::path& file) {
  return fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0;
}

Programs find_programs(DemHost host) {
  const char* chosen = std::getenv("GASGRAIN_BIN_DIR");
  const fs::path folder =
      chosen != nullptr ? fs::absolute(chosen) : fs::read_symlink("/proc/self/exe").parent_path();
  if (host == DemHost::lammps)
    return {on_path("lmp"), folder / "gasgrain-gas", on_path("mpirun"), folder / "gasgrain.lmp"};
  return {folder / "gasgrain-liggghts", folder / "gasgrain-gas", on_path("mpirun"), {}};
}

std::vector<std::string> program_faults(const Programs& programs, bool gas) {
  std::vector<std::string> faults;
  std::vector<fs::path> ours;
  if (programs.plugin.empty()) ours.push_back(programs.dem);
  if (gas) ours.push_back(programs.gas);
  for (const auto& program : ours)
    if (!is_executable(program))
      faults.push_back(fmt::format("{} is not in {}. Build it: ./bootstrap build",
                                   program.filename().string(), program.parent_path().string()));
  if (!programs.plugin.empty() && programs.dem.empty())
    faults.emplace_back("lmp is not on PATH. Install it: apt-get install lammps");
  if (!programs.plugin.empty() && !fs::is_regular_file(programs.plugin))
    faults.push_back(fmt::format(
        "{} is not in {}: gasgrain was built without LAMMPS. Install liblammps-dev, delete build/, "
        "then: ./bootstrap build (which says why, if it goes on without it).",
        programs.plugin.filename().string(), programs.plugin.parent_path().string()));
  if (programs.mpirun.empty())
    faults.emplace_back("mpirun is not on PATH. Install it: apt-get install openmpi-bin");
  return faults;
}

}  // namespace gasgrain
