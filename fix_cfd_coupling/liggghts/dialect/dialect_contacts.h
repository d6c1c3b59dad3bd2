// The contacts of grains, with what the pair style keeps of each: in the host's list of this step,
// and as stored with the grains.
#pragma once

#include <algorithm>
#include <cstddef>

#include "fix_cfd_coupling/liggghts/host_access.h"
// --
#include "fix_contact_history.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"

namespace gasgrain {

class HostContacts {
 public:
  // When a run begins.
  void find(LAMMPS_NS::LAMMPS& host) {
    pairs_ = static_cast<LAMMPS_NS::PairGran*>(host.force->pair_match("gran", 0));
  }
  explicit operator bool() const { return pairs_ != nullptr; }

  // f(i, j, row) for every listed pair of a grain i of this rank; j may be another's.
  template <class F>
  void for_each(const F& f) const {
    if (pairs_ == nullptr || pairs_->list == nullptr) return;
    const LAMMPS_NS::NeighList& list = *pairs_->list;
    const LAMMPS_NS::NeighList* history = pairs_->listgranhistory;
    if (history == nullptr) return;
    const std::ptrdiff_t width = pairs_->dnum();
    for (int n = 0; n < list.inum; ++n) {
      const int i = list.ilist[n];
      for (int m = 0; m < list.numneigh[i]; ++m)
        f(i, list.firstneigh[i][m] & NEIGHMASK, history->firstdouble[i] + m * width);
    }
  }

  // f(number of the other grain, row with k as its i) for every contact that the host has stored
  // with grain k when it last made its lists, or at the end of a run.
  template <class F>
  void for_each_stored(int k, const F& f) const {
    LAMMPS_NS::FixContactHistory* stored = pairs_->get_fix_history();
    if (stored == nullptr) return;
    for (int n = 0; n < stored->n_partner(k); ++n)
      f(stored->partner(k, n), stored->contacthistory(k, n));
  }

  // The host stores contacts when the next run begins, from a list of grains that the script may
  // have deleted meanwhile. It does so at once here.
  void store_now() const {
    if (auto* stored = pairs_->get_fix_history(); stored != nullptr) store_contacts_now(*stored);
  }

 private:
  LAMMPS_NS::PairGran* pairs_ = nullptr;
};

// Lists of contacts show what is nearer than `factor`, over the sum of the radii. The host has one
// distance for them and for walls of meshes.
inline void show_contacts_within(LAMMPS_NS::LAMMPS& host, double factor, double of_walls) {
  host.neighbor->register_contact_dist_factor(std::max(factor, of_walls));
}

}  // namespace gasgrain
