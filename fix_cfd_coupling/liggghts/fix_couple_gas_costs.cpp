// What fix couple/gas tells of the time that a run took: the host's own clocks, by its tasks, join
// those of the coupling.
#include <cstring>
#include <fstream>

#include "fix_cfd_coupling/liggghts/fix_couple_gas.h"
#include "fix_cfd_coupling/liggghts/host_session.h"
// --
#include "comm.h"
#include "modify.h"
#include "timer.h"
#include "update.h"

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
                                 {"collisional_exchange", "collisional exchange"}};
constexpr const char* other_fixes = "other fixes";

const char* task_of(const char* style) {
  for (const FixTask& each : fix_tasks)
    if (std::strncmp(style, each.style, std::strlen(each.style)) == 0) return each.task;
  return other_fixes;
}

}  // namespace

// The host's init() and setup() are outside of its clocks.
void FixCoupleGas::begin_setup_costs() {
  setup_begin_ = coupled_->costs().age() - coupled_->costs().named();
}

void FixCoupleGas::end_setup_costs() {
  auto& costs = coupled_->costs();
  costs.charge(costs.task("setup"), costs.age() - costs.named() - setup_begin_);
  // The host times each fix when it is asked to, here for the run only: else it would list them
  // all.
  times_fixes_ = modify->timing == 0;
  if (times_fixes_) modify->timing = 1;
  // It begins anew with each run, but only after this.
  for (int n = 0; n < modify->nfix; ++n) modify->fix[n]->reset_time_recording();
}

// Ours has tasks of its own.
void FixCoupleGas::charge_fixes() {
  auto& costs = coupled_->costs();
  for (int n = 0; n < modify->nfix; ++n)
    if (const Fix& fix = *modify->fix[n]; &fix != this)
      costs.charge(costs.task(task_of(fix.style)), fix.get_recorded_time());
}

void FixCoupleGas::take_host_costs() {
  auto& costs = coupled_->costs();
  costs.charge(costs.task("pair forces"), timer->array[TIME_PAIR]);
  costs.charge(costs.task("neighbour lists"), timer->array[TIME_NEIGHBOR]);
  costs.charge(costs.task("DEM communication"), timer->array[TIME_COMM]);
  costs.charge(costs.task("output"), timer->array[TIME_OUTPUT]);
  charge_fixes();
  if (times_fixes_) modify->timing = 0;
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
