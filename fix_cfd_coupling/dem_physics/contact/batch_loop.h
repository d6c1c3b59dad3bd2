// The vectorised loop over contacts as callers see it: one function for each instruction set and
// stack of laws. It is compiled in files of that instruction set (lane_stacks.cpp.in).
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/batch_store.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_laws.h"

namespace gasgrain::contact {

struct Avx2 {
  static constexpr int lanes = 4;
};
struct Avx512 {
  static constexpr int lanes = 8;
};

// As ContactLoop::pairs(), of laws that fit lanes. `store` has place for all grains and queues.
template <class Isa, class Laws>
void pairs_in_lanes(Laws& laws, BatchStore& store, const Grains& grains, const NeighbourList& list,
                    const ContactRows& rows, ContactObserver* observer);

}  // namespace gasgrain::contact
