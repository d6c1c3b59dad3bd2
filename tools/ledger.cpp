#include "tools/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace gasgrain {
namespace {

using nlohmann::json;

// Of the tasks of the DEM side that a run without gas would not have.
constexpr const char* coupling_prefix = "coupling:";

struct Cost {
  std::string task;
  double mean_s = 0.0;
  double max_s = 0.0;
};

std::string table(const std::string& side, const json& ledger) {
  if (!ledger.contains("tasks") || !ledger["tasks"].is_object()) return "";
  std::vector<Cost> costs;
  for (const auto& [task, seconds] : ledger["tasks"].items())
    if (seconds.is_object())
      costs.push_back({task, seconds.value("mean_s", 0.0), seconds.value("max_s", 0.0)});
  std::stable_sort(costs.begin(), costs.end(),
                   [](const Cost& a, const Cost& b) { return a.mean_s > b.mean_s; });
  // A side that times its whole names it "total"; else its tasks are all there is.
  double whole = 0.0;
  double coupling = 0.0;
  for (const auto& cost : costs) {
    whole += cost.mean_s;
    if (cost.task.rfind(coupling_prefix, 0) == 0) coupling += cost.mean_s;
  }
  if (!costs.empty() && costs.front().task == "total") whole = costs.front().mean_s;
  const double percent = whole > 0.0 ? 100.0 / whole : 0.0;
  const int ranks = ledger.value("ranks", 1);
  std::string text = fmt::format("  {:<34}{:>9}{:>9}{:>9}\n",
                                 fmt::format("{}, {} rank{}", side, ranks, ranks == 1 ? "" : "s"),
                                 "mean s", "max s", "share");
  for (const auto& cost : costs)
    text += fmt::format("    {:<32}{:>9.1f}{:>9.1f}{:>7.1f} %\n", cost.task, cost.mean_s,
                        cost.max_s, percent * cost.mean_s);
  if (coupling > 0.0)
    text += fmt::format("    {:<32}{:>9.1f}{:>9}{:>7.1f} %\n", "coupling, gas and waiting, all",
                        coupling, "", percent * coupling);
  return text;
}

}  // namespace

std::string merge_ledgers(const std::filesystem::path& results, double wall_s) {
  json merged;
  std::string text;
  for (const char* side : {"dem", "gas"}) {
    const auto file = results / fmt::format("ledger.{}.json", side);
    std::ifstream stream(file);
    const json part = json::parse(stream, nullptr, false);
    if (!part.is_object()) continue;
    merged[side] = part;
    text += table(side, part);
    std::filesystem::remove(file);
  }
  if (merged.is_null()) return "";
  merged["wall_s"] = wall_s;
  constexpr int indent = 2;
  std::ofstream(results / "ledger.json") << merged.dump(indent) << "\n";
  return text;
}

}  // namespace gasgrain
