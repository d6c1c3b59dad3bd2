#include "tools/ledger.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "coupling/base/cost_ledger.h"

namespace gasgrain {
namespace {

using nlohmann::json;

CostSummary summary_of(const json& side) {
  CostSummary summary;
  summary.ranks = side.value("ranks", 1);
  if (!side.contains("tasks") || !side["tasks"].is_object()) return summary;
  for (const auto& [task, seconds] : side["tasks"].items())
    if (seconds.is_object())
      summary.costs.push_back({task, seconds.value("mean_s", 0.0), seconds.value("max_s", 0.0)});
  return summary;
}

}  // namespace

std::string finish_ledger(const std::filesystem::path& results, double wall_s) {
  const auto file = results / "ledger.json";
  std::ifstream stream(file);
  json ledger = json::parse(stream, nullptr, false);
  if (!ledger.is_object()) return "";
  std::string text;
  for (const char* side : {"dem", "gas"})
    if (ledger.contains(side) && ledger[side].is_object())
      text += summary_of(ledger[side]).table(side);
  ledger["wall_s"] = wall_s;
  constexpr int indent = 2;
  std::ofstream(file) << ledger.dump(indent) << "\n";
  return text;
}

}  // namespace gasgrain
