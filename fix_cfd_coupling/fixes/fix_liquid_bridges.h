// The bridges in the host's list of contacts, and in what it stores of them with each grain.
#pragma once

#include "fix_cfd_coupling/fixes/fix_liquid.h"

namespace LAMMPS_NS {

// f(i, j, bridge) for every standing bridge of a grain of this rank; j may be another's.
template <class F>
void FixLiquid::for_each_bridge(const F& f) const {
  using gasgrain::liquid::StoredBridge;
  if (history_offset_ < 0) return;
  contacts_.for_each([&](int i, int j, double* row) {
    StoredBridge& b = gasgrain::liquid::stored_bridge(row + history_offset_);
    if (b.stands()) f(i, j, b);
  });
}

// f(number of the other grain, bridge with k as its i) for every bridge that the host has stored
// with grain k when it last made its lists, or at the end of a run.
template <class F>
void FixLiquid::for_each_stored(int k, const F& f) const {
  using gasgrain::liquid::StoredBridge;
  if (history_offset_ < 0) return;
  contacts_.for_each_stored(k, [&](int partner, double* row) {
    StoredBridge& b = gasgrain::liquid::stored_bridge(row + history_offset_);
    if (b.stands()) f(partner, b);
  });
}

}  // namespace LAMMPS_NS
