#include "coupling/run_history.h"

#include <fmt/ranges.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "coupling/base/error.h"

namespace gasgrain {

void write_run_frame(const std::string& folder, const RunFrame& frame) {
  const std::string name = folder + "/run.json";
  const std::string beside = name + ".new";
  {
    std::ofstream file(beside);
    file << fmt::format(
        "{{\"first_step\": {}, \"last_step\": {}, \"start_step\": {}, \"dt_s\": {:.17g}, "
        "\"time_end_s\": {:.17g}, \"host\": \"{}\", \"effects\": \"{}\"}}\n",
        frame.first_step, frame.last_step, frame.start_step, frame.dt,
        static_cast<double>(frame.last_step - frame.start_step) * frame.dt, frame.host,
        frame.effects);
    file.flush();
    if (!file)
      fail("{} cannot be written ({}): make the folder with 'output DIR', or free some space.",
           beside, std::strerror(errno));
  }
  std::filesystem::rename(beside, name);
}

HistoryFile::HistoryFile(const std::string& folder, const std::vector<std::string>& columns,
                         bool append)
    : name_(folder + "/history.csv"), columns_(columns.size()) {
  const std::string heading = fmt::format("{}", fmt::join(columns, ","));
  const bool go_on = append && std::filesystem::exists(name_);
  if (go_on) {
    std::string written;
    std::ifstream old(name_);
    std::getline(old, written);
    if (written != heading)
      fail(
          "{} has other columns than this run: restart with the effects and pressure probes it was "
          "written with, or move it away.",
          name_);
  }
  file_.reset(std::fopen(name_.c_str(), go_on ? "a" : "w"));
  if (!file_)
    fail("{} cannot be written ({}): does the folder exist? 'output DIR' names it.", name_,
         std::strerror(errno));
  if (go_on) return;
  std::fprintf(file_.get(), "%s\n", heading.c_str());
  std::fflush(file_.get());
}

void HistoryFile::write(const std::vector<double>& values) {
  if (values.size() != columns_)
    fail("{}: a line of {} values for {} columns.", name_, values.size(), columns_);
  for (std::size_t c = 0; c < values.size(); ++c)
    std::fprintf(file_.get(), "%s%.13g", c == 0 ? "" : ",", values[c]);
  std::fputc('\n', file_.get());
  if (std::fflush(file_.get()) != 0)
    fail("{} cannot be written on ({}): free some space; the last checkpoint is whole.", name_,
         std::strerror(errno));
}

}  // namespace gasgrain
