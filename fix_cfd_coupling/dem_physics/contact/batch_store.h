// Where the vectorised loop over contacts (contact_batch.h) works: the grains' state and forces
// side by side, and the contacts that were found but not yet computed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gasgrain::contact {

// x, y, z, R | v, m | w, 1 where frozen. One cache line and a half: most of a neighbour's state
// comes with its place.
struct alignas(32) GrainState {
  double place[4], motion[4], turning[4];
};
struct alignas(64) GrainPush {
  double force[4], torque[4];
};

// Contacts of one pair of types, in the order in which they were found.
struct alignas(64) ContactQueue {
  static constexpr int capacity = 64;
  int count = 0;
  int i[capacity], j[capacity];
  double* row[capacity];
  alignas(32) double delta[capacity][4];  // x_i - x_j, R_i + R_j
};

struct BatchStore {
  std::vector<GrainState> states;
  std::vector<GrainPush> pushes;
  std::vector<ContactQueue> queues;  // of a pair of types, as PairTable has them

  void make_place(int grains, std::size_t kinds_of_pairs) {
    const auto wanted = static_cast<std::size_t>(grains);
    if (states.size() < wanted) {
      states.resize(wanted + wanted / 8);
      pushes.resize(states.size());
    }
    queues.resize(std::max(queues.size(), kinds_of_pairs));
  }
};

}  // namespace gasgrain::contact
