// The host's `fix contacthistory`, which keeps with each grain what the pair style's list holds of
// its contacts, before lists are made anew.
//
// The host goes through all listed pairs twice, most of which do not touch, with a branch that
// nobody can foretell. Here the pairs in contact are picked out first, without branches; what is
// kept, and in which order, is the host's.
#pragma once

#include <cstddef>
#include <vector>

#include "fix_contact_history.h"

namespace LAMMPS_NS {

class FixContactHistoryPacked final : public FixContactHistory {
 public:
  using FixContactHistory::FixContactHistory;

  int setmask() override;
  void pre_exchange() override;
  // Says how many grains got new pairs by themselves (neighbor_sorted.h).
  void post_run() override;

 private:
  struct Contact {
    int i, j;
    const double* values;
  };

  void pick_contacts();

  std::vector<Contact> contacts_;  // the first `picked_` are of this list
  std::size_t picked_ = 0;
};

}  // namespace LAMMPS_NS
