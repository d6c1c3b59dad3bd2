// The bridges in the host's list of contacts, and in what it stores of them with each grain.
#pragma once

#include "fix_cfd_coupling/liggghts/fix_liquid.h"
// --
#include "fix_contact_history.h"
#include "neigh_list.h"
#include "pair_gran.h"

namespace LAMMPS_NS {

// f(i, j, bridge) for every standing bridge of a grain of this rank; j may be another's.
template <class F>
void FixLiquid::for_each_bridge(const F& f) const {
  using gasgrain::liquid::StoredBridge;
  if (history_offset_ < 0 || pairs_ == nullptr || pairs_->list == nullptr) return;
  const NeighList& list = *pairs_->list;
  const NeighList* history = pairs_->listgranhistory;
  if (history == nullptr) return;
  const int width = pairs_->dnum();
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n];
    double* row = history->firstdouble[i] + history_offset_;
    for (int m = 0; m < list.numneigh[i]; ++m) {
      StoredBridge& b =
          gasgrain::liquid::stored_bridge(row + static_cast<std::ptrdiff_t>(m) * width);
      if (b.stands()) f(i, list.firstneigh[i][m] & NEIGHMASK, b);
    }
  }
}

// f(number of the other grain, bridge with k as its i) for every bridge that the host has stored
// with grain k when it last made its lists, or at the end of a run.
template <class F>
void FixLiquid::for_each_stored(int k, const F& f) const {
  using gasgrain::liquid::StoredBridge;
  FixContactHistory* stored = history_offset_ < 0 ? nullptr : pairs_->get_fix_history();
  if (stored == nullptr) return;
  for (int n = 0; n < stored->n_partner(k); ++n) {
    StoredBridge& b =
        gasgrain::liquid::stored_bridge(stored->contacthistory(k, n) + history_offset_);
    if (b.stands()) f(stored->partner(k, n), b);
  }
}

}  // namespace LAMMPS_NS
