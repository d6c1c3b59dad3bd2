// What a loop over contacts works on: the host's arrays, its neighbour lists and where it keeps the
// contacts' history. Plain pointers; nothing is owned or copied.
#pragma once

#include <cstdint>

#include "fix_cfd_coupling/dem_physics/contact/triple.h"

namespace gasgrain::contact {

// Grains of this rank, then its ghosts. Units: SI.
struct Grains {
  using Vectors = const double (*)[3];
  Vectors x, v, spin;
  const double *radius, *mass;
  const int *type, *mask;  // types from 1
  double (*force)[3];
  double (*torque)[3];
  int owned;                // grains of this rank
  bool ghosts_take_forces;  // the host sums the forces on ghosts
  int frozen;               // bit of mask of grains that never move: their mass does not count
  const double* body_mass;  // where above 0: of the rigid body of which a grain is part; or null
  double dt;                // [s]
  std::int64_t step;        // its number
  bool updates;             // the history may change: not while forces are only looked at

  [[nodiscard]] double inertia(int i) const {
    return body_mass != nullptr && body_mass[i] > 0.0 ? body_mass[i] : mass[i];
  }
};

// Neighbours j of each grain i of the list; a pair stands once on a rank.
struct NeighbourList {
  int count;
  const int *grains, *neighbours;  // i of each entry; how many j has grain i
  const int* const* first;         // of grain i
  int index;                       // bits of j that are its number
};

// A row of doubles for each neighbour, and whether it is in use; null where no law has a history.
struct ContactRows {
  int* const* in_use = nullptr;  // of grain i, one for each neighbour
  double* const* values = nullptr;
  int width = 0;
};

// Grains that are or may come near to a wall, each once, and a row of doubles for each grain of the
// rank. Whether the row of the n-th of them is in use stands in in_use[n], or, where that is null,
// in the double after the row's values, of which there are `width`.
struct WallNeighbours {
  int count;
  const int* grains;
  double* const* rows;  // of grain i, or null
  int* in_use = nullptr;

  [[nodiscard]] [[gnu::always_inline]] inline bool is_in_use(int n, int width) const {
    return in_use != nullptr ? in_use[n] != 0 : rows[grains[n]][width] != 0.0;
  }
  [[gnu::always_inline]] inline void set_in_use(int n, int width, bool yes) const {
    if (in_use != nullptr)
      in_use[n] = static_cast<int>(yes);
    else
      rows[grains[n]][width] = static_cast<double>(yes);
  }
};

// Told of each contact that acts: force on i [N], from j or the wall to i [m].
class ContactObserver {
 public:
  virtual void acts(int i, int j, const Triple& force, const Triple& delta) = 0;

 protected:
  ~ContactObserver() = default;
};

}  // namespace gasgrain::contact
