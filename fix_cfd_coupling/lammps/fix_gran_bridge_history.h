// `NEIGH_HISTORY/gran/bridge`: where `pair_style gran/bridge` keeps what it knows of each contact.
// The pair style makes it; scripts do not.
//
// The host's own fix NEIGH_HISTORY, but for one thing. That one stores the rows of the neighbour
// list with the grains whenever a restart file is written. The command `write_restart`, between two
// runs, has handed the grains to other ranks before, and the rows of a list of other grains would
// be stored. Here what was stored at the end of the run stays.
#pragma once

#include <cstddef>

#include "comm.h"
#include "fix_neigh_history.h"
#include "update.h"

namespace LAMMPS_NS {

class FixGranBridgeHistory : public FixNeighHistory {
 public:
  FixGranBridgeHistory(LAMMPS* host, int narg, char** arg) : FixNeighHistory(host, narg, arg) {}

  void write_restart(FILE* file) override {
    if (update->whichflag != 0) return FixNeighHistory::write_restart(file);
    const int nothing_of_all = 0;
    if (comm->me == 0) fwrite(&nothing_of_all, sizeof(int), 1, file);
  }

  // What is stored with grain k: how many contacts; of the n-th the other grain's number, and the
  // row with k as its i.
  [[nodiscard]] int stored(int k) const { return npartner[k]; }
  [[nodiscard]] int stored_other(int k, int n) const { return partner[k][n]; }
  [[nodiscard]] double* stored_row(int k, int n) const {
    return valuepartner[k] + static_cast<std::ptrdiff_t>(n) * dnum;
  }
};

}  // namespace LAMMPS_NS
