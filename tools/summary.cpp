#include "tools/summary.h"

#include <fmt/format.h>

#include "tools/history.h"
#include "tools/progress_text.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

struct Peak {
  double value = 0.0;
  double time_s = 0.0;
};

// The greatest value of a column after the gas has started.
std::optional<Peak> peak(const History& history, const std::string& column) {
  std::optional<Peak> best;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    const auto time = history.value(row, "time_s");
    const auto value = history.value(row, column);
    if (time && value && *time >= 0.0 && (!best || *value > best->value)) best = {*value, *time};
  }
  return best;
}

bool has_files(const fs::path& folder) {
  return fs::is_directory(folder) && fs::directory_iterator(folder) != fs::directory_iterator();
}

}  // namespace

std::string summary(const fs::path& results, double wall_s, const std::string& costs) {
  History history(results / "history.csv");
  history.read_on();
  std::string text = fmt::format("  {:<18}{}\n", "wall time", clock_text(wall_s));
  if (const auto time = history.last("time_s"))
    text += fmt::format("  {:<18}{:.4g} s\n", "simulated time", *time);
  if (const auto bed = peak(history, "bed_height_m"))
    text += fmt::format("  {:<18}at most {:.4f} m, at {:.4g} s\n", "bed height", bed->value,
                        bed->time_s);
  if (const auto overlap = peak(history, "max_overlap"))
    text += fmt::format("  {:<18}{:.2g} % of a diameter, at {:.4g} s\n", "greatest overlap",
                        100.0 * overlap->value, overlap->time_s);
  if (const auto residual = history.last("ledger_residual"))
    text += fmt::format("  {:<18}{:.2g}\n", "ledger residual", *residual);
  return costs.empty() ? text : text + "Cost by task:\n" + costs;
}

std::string made_files(const fs::path& results) {
  std::string text;
  for (const char* name : {"history.csv", "history.png", "bed.png", "gas.xdmf",
                           "particles.vtk.series", "ledger.json", "run.log"})
    if (fs::exists(results / name)) text += fmt::format("  {}\n", (results / name).string());
  for (const char* name : {"particles", "checkpoint"})
    if (has_files(results / name)) text += fmt::format("  {}/\n", (results / name).string());
  return text;
}

}  // namespace gasgrain
