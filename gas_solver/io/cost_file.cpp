#include "gas_solver/io/cost_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"

namespace gasgrain {

std::string told_costs(CostLedger& costs, const Communicator& comm) {
  costs.close();
  const CostSummary summary = costs.over(comm);
  if (!comm.is_root()) return "";
  fmt::print("{}", summary.table("gas"));
  std::fflush(stdout);
  return summary.json();
}

void write_costs(CostLedger& costs, const std::string& folder, const Communicator& comm) {
  const std::string gas = told_costs(costs, comm);
  if (!comm.is_root()) return;
  const std::string name = folder + "/ledger.json";
  std::ofstream out(name);
  if (!(out << ledger_json({{"gas", gas}}) << std::flush))
    fail("{}: cannot be written: {}.", name, why_not_written(name));
}

}  // namespace gasgrain
