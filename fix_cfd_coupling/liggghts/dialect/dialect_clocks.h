// The host's own clocks of a run, by task. LIGGGHTS times each fix when it is asked to.
#pragma once

#include "fix_cfd_coupling/liggghts/neighbor_sorted.h"
// --
#include "fix.h"
#include "modify.h"
#include "timer.h"

namespace gasgrain {

class HostClocks {
 public:
  // When the setup of a run ends. The host would list all fixes in its own summary if it were asked
  // for good: it is, for the run only.
  void begin_run(LAMMPS_NS::Modify& modify) {
    asked_ = modify.timing == 0;
    if (asked_) modify.timing = 1;
    // It begins anew with each run, but only after this.
    for (int n = 0; n < modify.nfix; ++n) modify.fix[n]->reset_time_recording();
  }

  // charge(task, seconds) for the run's tasks, charge_fix(style, seconds) for each fix but `own`,
  // whose time other clocks have (here nobody needs to know how much that was).
  template <class Charge, class ChargeFix>
  void end_run(LAMMPS_NS::LAMMPS& host, const LAMMPS_NS::Fix* own, double /*seconds_of_own*/,
               Charge charge, ChargeFix charge_fix) {
    // New pairs of single grains are looked for when the pair style begins.
    const double renewals = NeighborSorted::of(host).renewal_seconds();
    charge("pair forces", host.timer->array[TIME_PAIR] - renewals);
    charge("neighbour lists", host.timer->array[TIME_NEIGHBOR] + renewals);
    charge("DEM communication", host.timer->array[TIME_COMM]);
    charge("output", host.timer->array[TIME_OUTPUT]);
    for (int n = 0; n < host.modify->nfix; ++n)
      if (const LAMMPS_NS::Fix& fix = *host.modify->fix[n]; &fix != own)
        charge_fix(fix.style, fix.get_recorded_time());
    if (asked_) host.modify->timing = 0;
  }

 private:
  bool asked_ = false;
};

}  // namespace gasgrain
