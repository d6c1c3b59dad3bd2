// The host's own clocks of a run, by task. LAMMPS has one for all fixes together.
#pragma once

#include <algorithm>

#include "lammps.h"
// --
#include "fix.h"
#include "modify.h"
#include "timer.h"

namespace gasgrain {

class HostClocks {
 public:
  // When the setup of a run ends.
  void begin_run(LAMMPS_NS::Modify&) {}

  // charge(task, seconds) for the run's tasks, charge_fix(style, seconds) for the fixes but `own`,
  // whose time other clocks have.
  template <class Charge, class ChargeFix>
  void end_run(LAMMPS_NS::LAMMPS& host, const LAMMPS_NS::Fix* /*own*/, double seconds_of_own,
               Charge charge, ChargeFix charge_fix) {
    using LAMMPS_NS::Timer;
    charge("pair forces", host.timer->get_wall(Timer::PAIR));
    charge("neighbour lists", host.timer->get_wall(Timer::NEIGH));
    charge("DEM communication", host.timer->get_wall(Timer::COMM));
    charge("output", host.timer->get_wall(Timer::OUTPUT));
    charge_fix("all", std::max(0.0, host.timer->get_wall(Timer::MODIFY) - seconds_of_own));
  }
};

}  // namespace gasgrain
