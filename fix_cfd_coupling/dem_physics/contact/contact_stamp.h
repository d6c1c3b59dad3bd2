// Whether what a contact's history says is of the step before.
//
// A host shows a law the bodies up to a distance and says nothing when they leave it: two grains
// that part by more than that in one step and meet again later would find the state of the first
// meeting. A history value that holds the step of its last update tells.
#pragma once

#include <mpi.h>

#include <cstdint>

#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

namespace gasgrain::contact {

class ContactStamp {
 public:
  // Before a run: the step from which it goes on. Where the script has set the step back, the last
  // step seen, on any rank, stands for the step before; where it was set forward, what contacts
  // hold is taken for torn.
  void begin_run(const ContactHost& host) {
    first_ = static_cast<double>(host.step());
    double last = last_;
    MPI_Allreduce(&last, &before_reset_, 1, MPI_DOUBLE, MPI_MAX, host.communicator());
    if (before_reset_ <= first_ + 1.0) before_reset_ = never;
  }

  // The history value 0 of a new contact is never of the step before.
  [[nodiscard]] bool holds(double stamp, std::int64_t step) const {
    if (stamp == never) return false;
    const double now = static_cast<double>(step);
    const double age = now + 1.0 - stamp;
    return (age >= 0.0 && age <= 1.0) || (stamp == before_reset_ && now - first_ <= 1.0);
  }
  // The value to store now.
  double now(std::int64_t step) {
    last_ = static_cast<double>(step) + 1.0;
    return last_;
  }

 private:
  static constexpr double never = 0.0;

  double first_ = 0.0;
  double last_ = never;  // stamp
  double before_reset_ = never;
};

}  // namespace gasgrain::contact
