// Whether what a contact's history says is of the step before.
//
// The host calls a model for pairs up to a distance and says nothing when a pair leaves it: two
// grains that part by more than that in one step and meet again later would find the state of the
// first meeting. A history value that holds the step of its last update tells.
#pragma once

#include "lammps.h"
// --
#include "update.h"

namespace gasgrain {

class ContactStamp {
 public:
  // At the host's init: the step from which the run goes on. Where `reset_timestep` has set it
  // back, the last step seen, on any rank, stands for the step before; where it was set forward,
  // what contacts hold is taken for torn.
  void begin_run(LAMMPS_NS::LAMMPS& host) {
    host_ = &host;
    first_ = static_cast<double>(host.update->ntimestep);
    double last = last_;
    MPI_Allreduce(&last, &before_reset_, 1, MPI_DOUBLE, MPI_MAX, host.world);
    if (before_reset_ <= first_ + 1.0) before_reset_ = never;
  }

  // The history value 0 of a new contact is never of the step before.
  [[nodiscard]] bool holds(double stamp) const {
    if (stamp == never) return false;
    const double age = step() + 1.0 - stamp;
    return (age >= 0.0 && age <= 1.0) || (stamp == before_reset_ && step() - first_ <= 1.0);
  }
  // The value to store now.
  double now() {
    last_ = step() + 1.0;
    return last_;
  }

 private:
  static constexpr double never = 0.0;
  [[nodiscard]] double step() const { return static_cast<double>(host_->update->ntimestep); }

  LAMMPS_NS::LAMMPS* host_ = nullptr;
  double first_ = 0.0;
  double last_ = never;  // stamp
  double before_reset_ = never;
};

}  // namespace gasgrain
