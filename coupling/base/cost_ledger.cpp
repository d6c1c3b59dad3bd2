#include "coupling/base/cost_ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace gasgrain {

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

double CostLedger::unnamed() const {
  const double named = std::accumulate(seconds_.begin(), seconds_.end(), 0.0) - seconds(total);
  return seconds(total) - named;
}

std::string CostLedger::json(const Communicator& comm) const {
  std::string tasks;
  for (std::size_t n = 0; n < names_.size(); ++n)
    tasks += fmt::format("{}\"{}\": {{\"mean_s\": {:.6g}, \"max_s\": {:.6g}}}", n == 0 ? "" : ", ",
                         names_[n], comm.sum(seconds_[n]) / comm.size(), comm.max(seconds_[n]));
  return fmt::format("{{\"ranks\": {}, \"tasks\": {{{}}}}}", comm.size(), tasks);
}

}  // namespace gasgrain
