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

Programs find_programs() {
  const char* chosen = std::getenv("GASGRAIN_BIN_DIR");
  const fs::path folder =
      chosen != nullptr ? fs::absolute(chosen) : fs::read_symlink("/proc/self/exe").parent_path();
  return {folder / "gasgrain-liggghts", folder / "gasgrain-gas", on_path("mpirun")};
}

std::vector<std::string> program_faults(const Programs& programs, bool gas) {
  std::vector<std::string> faults;
  for (const auto& program : {programs.dem, programs.gas})
    if ((gas || program != programs.gas) && !is_executable(program))
      faults.push_back(fmt::format("{} is not in {}. Build it: ./bootstrap build",
                                   program.filename().string(), program.parent_path().string()));
  if (programs.mpirun.empty())
    faults.emplace_back("mpirun is not on PATH. Install it: apt-get install openmpi-bin");
  return faults;
}

}  // namespace gasgrain
