// The vectorised loop over contacts as callers see it: one function for each instruction set and
// stack of laws. It is compiled in files of that instruction set (lane_stacks.cpp.in).
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/contact_laws.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_queue.h"

namespace gasgrain::contact {

struct Avx2 {
  static constexpr int lanes = 4;
};
struct Avx512 {
  static constexpr int lanes = 8;
};

// As ContactLoop::pairs(), of laws that fit lanes. `queues`: one for each pair of types, at its
// place in a PairTable, empty before and after.
template <class Isa, class Laws>
void pairs_in_lanes(Laws& laws, ContactQueue* queues, const Grains& grains,
                    const NeighbourList& list, const ContactRows& rows, ContactObserver* observer);

// As ContactLoop::wall(), likewise.
template <class Isa, class Laws>
void wall_in_lanes(Laws& laws, ContactQueue* queues, const Grains& grains,
                   const WallNeighbours& near, const PrimitiveWall& shape, int type,
                   ContactObserver* observer);

}  // namespace gasgrain::contact
