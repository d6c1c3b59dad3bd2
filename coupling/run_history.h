// The record of a run that people and the `gasgrain` command read while it goes on: run.json (its
// frame, written when a run starts) and history.csv (one flushed line a coupling).
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace gasgrain {

// Steps and times of the run that starts; time is the gas's (negative while the bed is packed).
struct RunFrame {
  long first_step = 0;
  long last_step = 0;
  long start_step = 0;  // at which the gas starts
  double dt = 0.0;      // DEM step [s]
  std::string host;     // program and version
  std::string effects;  // as the scene named them
};

// Writes `<folder>/run.json` beside the old one and renames it. Throws Error when it cannot.
void write_run_frame(const std::string& folder, const RunFrame& frame);

class HistoryFile {
 public:
  // Opens `<folder>/history.csv`; a new one begins with the names of the columns, an old one of the
  // same columns is appended to when `append`. Throws Error when it cannot be written.
  HistoryFile(const std::string& folder, const std::vector<std::string>& columns, bool append);
  // One line, flushed; throws Error when the disk is full.
  void write(const std::vector<double>& values);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string name_;
  std::size_t columns_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace gasgrain
