#include "tools/study/point_figures.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/history.h"

namespace gasgrain {
namespace {

using nlohmann::json;

// Seconds of the tasks whose names begin so, on the rank that spends most.
double seconds(const json& tasks, const std::string& prefix) {
  double sum = 0.0;
  for (const auto& [name, task] : tasks.items())
    if (name.rfind(prefix, 0) == 0) sum += task.value("max_s", 0.0);
  return sum;
}

// First to last line of the history, the packing included [s].
double simulated(const History& history) {
  const auto first = history.value(0, "time_s");
  const auto last = history.last("time_s");
  return first && last ? *last - *first : 0.0;
}

struct Column {
  double sum = 0.0;
  double greatest = 0.0;
  int count = 0;
  [[nodiscard]] double mean() const { return count > 0 ? sum / count : std::nan(""); }
};

Column of_gas_stage(const History& history, const std::string& name) {
  Column column;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    const auto time = history.value(row, "time_s");
    const auto value = history.value(row, name);
    if (!time || !value || *time <= 0.0) continue;
    column.sum += *value;
    column.greatest = std::max(column.greatest, *value);
    ++column.count;
  }
  return column;
}

}  // namespace

void add_point_figures(const std::filesystem::path& results, Figures& figures) {
  History history(results / "history.csv");
  history.read_on();
  std::ifstream stream(results / "ledger.json");
  const json ledger = json::parse(stream, nullptr, false);
  if (ledger.is_object() && ledger.contains("dem") && ledger["dem"].contains("tasks")) {
    const json& tasks = ledger["dem"]["tasks"];
    const double total = seconds(tasks, "total");
    const double time = simulated(history);
    if (time > 0.0) figures.set("wall_s_per_s", total / time);
    if (total > 0.0) {
      figures.set("void_fraction_share", seconds(tasks, "coupling: void fraction") / total);
      figures.set("waiting_share", seconds(tasks, "coupling: waiting") / total);
      figures.set("gas_share", seconds(tasks, "coupling:") / total);
    }
  }
  figures.set("bed_height_m", of_gas_stage(history, "bed_height_m").mean());
  figures.set("bubble_diameter_m", of_gas_stage(history, "bubble_diameter_m").mean());
  figures.set("overlap", of_gas_stage(history, "max_overlap").greatest);
  figures.set("gas_substeps", of_gas_stage(history, "gas_substeps").mean());
  double clamps = 0.0;
  for (const char* name : {"moved_cells", "too_dense", "beyond_walls", "disturbance_cut"})
    clamps += of_gas_stage(history, name).sum;
  figures.set("clamps", clamps);
}

}  // namespace gasgrain
