// The contacts of grains, with what the pair style keeps of each: in the host's list of this step,
// and as stored with the grains.
#pragma once

#include <cstddef>

#include "fix_cfd_coupling/lammps/fix_gran_bridge_history.h"
#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"
// --
#include "force.h"
#include "neigh_list.h"

namespace gasgrain {

class HostContacts {
 public:
  // When a run begins.
  void find(LAMMPS_NS::LAMMPS& host) {
    pairs_ = dynamic_cast<LAMMPS_NS::PairGranBridge*>(host.force->pair_match("gran/bridge", 1));
  }
  explicit operator bool() const { return pairs_ != nullptr; }

  // f(i, j, row) for every listed pair of a grain i of this rank; j may be another's.
  template <class F>
  void for_each(const F& f) const {
    if (pairs_ == nullptr || pairs_->list == nullptr) return;
    const LAMMPS_NS::NeighList& list = *pairs_->list;
    const LAMMPS_NS::FixGranBridgeHistory* history = pairs_->history_fix();
    if (history == nullptr) return;
    const std::ptrdiff_t width = pairs_->history_width();
    for (int n = 0; n < list.inum; ++n) {
      const int i = list.ilist[n];
      for (int m = 0; m < list.numneigh[i]; ++m)
        f(i, list.firstneigh[i][m] & NEIGHMASK, history->firstvalue[i] + m * width);
    }
  }

  // f(number of the other grain, row with k as its i) for every contact that the host has stored
  // with grain k when it last made its lists, or at the end of a run.
  template <class F>
  void for_each_stored(int k, const F& f) const {
    const LAMMPS_NS::FixGranBridgeHistory* history = pairs_->history_fix();
    if (history == nullptr) return;
    for (int n = 0; n < history->stored(k); ++n)
      f(history->stored_other(k, n), history->stored_row(k, n));
  }

  // The host stores contacts at the end of a run by itself.
  void store_now() const {}

 private:
  LAMMPS_NS::PairGranBridge* pairs_ = nullptr;
};

// Lists of contacts show what is nearer than `factor`, over the sum of the radii; walls have
// distances of their own (show_wall_within()).
inline void show_contacts_within(LAMMPS_NS::LAMMPS& host, double factor, double /*of_walls*/) {
  if (auto* pairs =
          dynamic_cast<LAMMPS_NS::PairGranBridge*>(host.force->pair_match("gran/bridge", 1)))
    pairs->reach_at_least(factor);
}

}  // namespace gasgrain
