#include "tools/results_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "coupling/base/error.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

// A folder that no run of ours has written to is not cleared, whatever its files are called.
bool holds_a_run(const fs::path& folder) {
  return fs::exists(folder / "run.json") || fs::exists(folder / "history.csv") ||
         fs::exists(folder / "run.log");
}

bool is_run_file(const fs::path& file) {
  const std::string name = file.filename();
  for (const char* known :
       {"history.csv", "run.json", "gas.h5", "gas.xdmf", "packed.restart", "particles.vtk.series",
        "measured.csv", "measured_curve.csv", "measured.json", "analyse.toml", "solid_drag.csv",
        "solid_drag_windows.csv", "solid_drag.json", "centre_line.csv"})
    if (name == known) return true;
  return file.extension() == ".png" ||
         (name.rfind("ledger", 0) == 0 && file.extension() == ".json") || name == "audit.txt" ||
         name == "audit.json";
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (!entry.is_directory()) files.push_back(entry.path());
  return files;
}

void clear(const fs::path& folder) {
  for (const auto& file : files_in(folder))
    if (is_run_file(file)) fs::remove(file);
  for (const char* part : {"particles", "checkpoint"})
    for (const auto& file : files_in(folder / part)) fs::remove(file);
}

}  // namespace

fs::path results_path(const RunOptions& options) {
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  // The dot makes 'inputs/bed/' and 'inputs/bed' alike.
  const fs::path scene = (fs::absolute(options.scene) / ".").lexically_normal().parent_path();
  return fs::absolute("results") / scene.filename();
}

fs::path gas_checkpoint(const fs::path& results, long step) {
  return results / "checkpoint" / fmt::format("gas.{}.h5", step);
}

std::optional<long> newest_checkpoint(const fs::path& results) {
  static const std::regex dem_part(R"(dem\.([0-9]{1,18})\.restart)");  // 18 digits fit a long
  std::optional<long> newest;
  for (const auto& file : files_in(results / "checkpoint")) {
    const std::string name = file.filename();
    std::smatch match;
    if (!std::regex_match(name, match, dem_part)) continue;
    const long number = std::stol(match[1]);
    if (fs::exists(gas_checkpoint(results, number))) newest = std::max(newest.value_or(0), number);
  }
  return newest;
}

ResultsFolder::ResultsFolder(fs::path path, bool keep) : path_(std::move(path)) {
  const bool used = holds_a_run(path_);
  fs::create_directories(path_ / "particles");
  fs::create_directories(path_ / "checkpoint");
  const std::string log = file("run.log");
  log_ = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (log_ < 0) fail("{} cannot be written. Choose another folder: --out DIR", log);
  // The launched mpirun shares the lock, so that it lasts as long as either program.
  if (flock(log_, LOCK_EX | LOCK_NB) != 0)
    fail("another run is writing to {}. Wait for it, or choose another folder: --out DIR",
         path_.string());
  if (used && !keep) clear(path_);
  if (ftruncate(log_, 0) != 0) fail("{} cannot be emptied.", log);
}

ResultsFolder::~ResultsFolder() {
  close(log_);
}

}  // namespace gasgrain
