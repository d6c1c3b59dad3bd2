// The folder a run writes to: made, locked, cleared, and searched for checkpoints.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/run_options.h"

namespace gasgrain {

// Absolute path of the results folder of a run.
std::filesystem::path results_path(const RunOptions& options);

// The newest step with both halves of a checkpoint, dem.STEP.restart and gas.STEP.h5.
std::optional<long> newest_checkpoint(const std::filesystem::path& results);
std::filesystem::path gas_checkpoint(const std::filesystem::path& results, long step);

class ResultsFolder {
 public:
  // Makes the folder with particles/ and checkpoint/ and opens run.log, empty. The files of an
  // earlier run are removed unless `keep`. Throws Error when another run writes there.
  ResultsFolder(std::filesystem::path path, bool keep);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }
  // File descriptor of run.log.
  [[nodiscard]] int log() const { return log_; }

 private:
  std::filesystem::path path_;
  int log_ = -1;
};

}  // namespace gasgrain
