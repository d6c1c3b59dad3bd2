// What fix couple/gas tells of the time that a run took: the host's own clocks, by its tasks, join
// those of the coupling.
#include <cstring>
#include <fstream>

#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "comm.h"
#include "modify.h"

namespace LAMMPS_NS {

namespace {

struct FixTask {
  const char* style;  // how it begins
  const char* task;
};
constexpr FixTask fix_tasks[] = {{"wall/", "walls"},
                                 {"mesh/", "walls"},
                                 {"nve", "integration"},
                                 {"insert/", "insertion"},
                                 {"parcels/inject", "insertion"},
                                 {"parcels", "parcels"},
                                 {"collisional_exchange", "collisional exchange"},
                                 {"exchange/bgk", "collisional exchange"}};

const char* task_of(const char* style) {
  for (const FixTask& each : fix_tasks)
    if (std::strncmp(style, each.style, std::strlen(each.style)) == 0) return each.task;
  return "other fixes";
}

}  // namespace

// The host's init() and setup() are outside of its clocks.
void FixCoupleGas::begin_setup_costs() {
  setup_begin_ = coupled_->costs().age() - coupled_->costs().named();
}

void FixCoupleGas::end_setup_costs() {
  auto& costs = coupled_->costs();
  costs.charge(costs.task("setup"), costs.age() - costs.named() - setup_begin_);
  named_before_ = costs.named();
  host_clocks_.begin_run(*modify);
}

// Ours has tasks of its own.
void FixCoupleGas::take_host_costs() {
  auto& costs = coupled_->costs();
  host_clocks_.end_run(
      *lmp, this, costs.named() - named_before_,
      [&](const char* task, double seconds) { costs.charge(costs.task(task), seconds); },
      [&](const char* of_fix, double seconds) {
        costs.charge(costs.task(task_of(of_fix)), seconds);
      });
}

// The end of the run: both sides' ledgers become ledger.json.
void FixCoupleGas::tell_costs() {
  auto& costs = coupled_->costs();
  costs.close();
  const auto summary = costs.over(gasgrain::session().local);
  const bool tells = gasgrain::session().local.is_root();
  if (tells)
    for (FILE* sink : {screen, logfile})
      if (sink != nullptr) fmt::print(sink, "{}", summary.table("DEM"));
  const std::string gas = coupled_->finish();
  if (tells)
    std::ofstream(output_ + "/ledger.json")
        << gasgrain::ledger_json({{"dem", summary.json()}, {"gas", gas}});
}

}  // namespace LAMMPS_NS
