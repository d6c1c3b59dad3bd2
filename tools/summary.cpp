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

// Sum of a column after the gas has started.
double sum(const History& history, const std::string& column) {
  double total = 0.0;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    const auto time = history.value(row, "time_s");
    const auto value = history.value(row, column);
    if (time && value && *time >= 0.0) total += *value;
  }
  return total;
}

struct Clamp {
  const char* column;
  const char* text;
};
constexpr Clamp clamps[] = {
    {"moved_cells", "times a cell held more than 80 % of solids: the excess was moved"},
    {"too_dense", "times a grain's void fraction was below 0.2: its drag law was taken at 0.2"},
    {"beyond_walls", "times a grain's centre was outside of the box: its solids went to the wall"},
    {"interval_too_long",
     "couplings were too far apart for the grains: run.log names the 'every N'"},
    {"momentum_not_converged", "components of the gas's momentum missed the tolerance"},
    {"pressure_not_converged", "steps of the gas missed the tolerance of continuity"},
    {"outer_not_converged", "steps of the gas used all their outer iterations"},
    {"turbulence_clamped", "values of k, e or mu_t were cut or raised"},
    {"turbulence_not_converged", "equations of k or e missed the tolerance"},
    {"backflow_faces", "outlet faces (summed over the lines) let gas in"}};

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
  for (const Clamp& clamp : clamps)
    if (const double count = sum(history, clamp.column); count > 0.0)
      text += fmt::format("  note: {:.0f} {}\n", count, clamp.text);
  return costs.empty() ? text : text + "Cost by task:\n" + costs;
}

std::string made_files(const fs::path& results) {
  std::string text;
  for (const char* name :
       {"history.csv", "history.png", "bed.png", "gas.xdmf", "particles.vtk.series", "ledger.json",
        "audit.txt", "measured.csv", "measured_curve.csv", "measured.png", "run.log"})
    if (fs::exists(results / name)) text += fmt::format("  {}\n", (results / name).string());
  for (const char* name : {"particles", "checkpoint"})
    if (has_files(results / name)) text += fmt::format("  {}/\n", (results / name).string());
  return text;
}

}  // namespace gasgrain
