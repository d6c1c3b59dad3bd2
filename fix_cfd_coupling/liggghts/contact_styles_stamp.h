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
  // At the host's init: the step from which the run goes on. `reset_timestep` may have changed it;
  // then the last step seen, on any rank, stands for the step before.
  void begin_run(LAMMPS_NS::LAMMPS& host) {
    host_ = &host;
    first_ = host.update->ntimestep;
    double last = last_;
    MPI_Allreduce(&last, &resumed_, 1, MPI_DOUBLE, MPI_MAX, host.world);
  }

  // The history value 0 of a new contact is never of the step before.
  [[nodiscard]] bool holds(double stamp) const {
    if (stamp == 0.0) return false;
    const double now = step();
    const double age = now + 1.0 - stamp;
    return (age >= 0.0 && age <= 1.0) || (stamp == resumed_ && now - first_ <= 1.0);
  }
  // The value to store now.
  double now() {
    last_ = step() + 1.0;
    return last_;
  }

 private:
  [[nodiscard]] double step() const { return static_cast<double>(host_->update->ntimestep); }

  LAMMPS_NS::LAMMPS* host_ = nullptr;
  double first_ = 0.0;
  double last_ = 0.0;  // stamp
  double resumed_ = 0.0;
};

}  // namespace gasgrain
