#include "gas_solver/io/cost_file.h"

#include <fstream>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"

namespace gasgrain {

void write_costs(const CostLedger& costs, const std::string& folder, const Communicator& comm) {
  const std::string ledger = costs.json(comm);
  if (!comm.is_root()) return;
  const std::string name = folder + "/ledger.gas.json";
  std::ofstream out(name);
  if (!(out << ledger << std::endl))
    fail("{}: cannot be written: {}.", name, why_not_written(name));
}

}  // namespace gasgrain
