#include "coupling/base/cost_ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace gasgrain {

std::string CostSummary::json() const {
  std::string tasks;
  for (const Cost& cost : costs)
    tasks += fmt::format("{}\"{}\": {{\"mean_s\": {:.6g}, \"max_s\": {:.6g}}}",
                         tasks.empty() ? "" : ", ", cost.task, cost.mean_s, cost.max_s);
  return fmt::format("{{\"ranks\": {}, \"tasks\": {{{}}}}}", ranks, tasks);
}

std::string CostSummary::table(const std::string& side) const {
  std::vector<Cost> sorted = costs;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Cost& a, const Cost& b) {
    return (a.task == CostLedger::total) != (b.task == CostLedger::total)
               ? a.task == CostLedger::total
               : a.mean_s > b.mean_s;
  });
  // A side that times its whole names it; else its tasks are all there is.
  double whole = 0.0;
  double coupling = 0.0;
  for (const Cost& cost : sorted) {
    whole += cost.mean_s;
    if (cost.task.rfind(CostLedger::coupling_prefix, 0) == 0) coupling += cost.mean_s;
  }
  if (!sorted.empty() && sorted.front().task == CostLedger::total) whole = sorted.front().mean_s;
  const double percent = whole > 0.0 ? 100.0 / whole : 0.0;
  std::string text = fmt::format("  {:<40}{:>9}{:>9}{:>9}\n",
                                 fmt::format("{}, {} rank{}", side, ranks, ranks == 1 ? "" : "s"),
                                 "mean s", "max s", "share");
  for (const Cost& cost : sorted)
    text += fmt::format("    {:<38}{:>9.2f}{:>9.2f}{:>7.1f} %\n", cost.task, cost.mean_s,
                        cost.max_s, percent * cost.mean_s);
  if (coupling > 0.0)
    text += fmt::format("    {:<38}{:>9.2f}{:>9}{:>7.1f} %\n", "coupling, gas and waiting, all",
                        coupling, "", percent * coupling);
  return text;
}

std::string ledger_json(const std::vector<std::pair<std::string, std::string>>& sides) {
  std::string members;
  for (const auto& [side, object] : sides)
    members += fmt::format("{}  \"{}\": {}", members.empty() ? "" : ",\n", side, object);
  return fmt::format("{{\n{}\n}}\n", members);
}

std::size_t CostLedger::task(const std::string& name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
  names_.push_back(name);
  seconds_.push_back(0.0);
  return names_.size() - 1;
}

double CostLedger::seconds(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? 0.0 : seconds_[static_cast<std::size_t>(found - names_.begin())];
}

double CostLedger::named() const {
  return std::accumulate(seconds_.begin(), seconds_.end(), 0.0) - seconds(total);
}

void CostLedger::close() {
  charge(task(total), age() - seconds(total));
  charge(task(other), unnamed());
}

CostSummary CostLedger::over(const Communicator& comm) const {
  CostSummary summary;
  summary.ranks = comm.size();
  for (std::size_t n = 0; n < names_.size(); ++n)
    summary.costs.push_back(
        {names_[n], comm.sum(seconds_[n]) / comm.size(), comm.max(seconds_[n])});
  return summary;
}

}  // namespace gasgrain
