// The bridges in the host's list of contacts.
#pragma once

#include "fix_cfd_coupling/liggghts/fix_liquid.h"
// --
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
    const double* row = history->firstdouble[i] + history_offset_;
    for (int m = 0; m < list.numneigh[i]; ++m) {
      const double* h = row + static_cast<std::ptrdiff_t>(m) * width;
      const StoredBridge b{h[0], h[1], h[2]};
      if (b.stands()) f(i, list.firstneigh[i][m] & NEIGHMASK, b);
    }
  }
}

}  // namespace LAMMPS_NS
