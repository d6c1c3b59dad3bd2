#include "fix_cfd_coupling/lammps/compute_pair_gran_local.h"

#include <algorithm>
#include <cstring>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/lammps/fix_gran_bridge_history.h"
#include "fix_cfd_coupling/lammps/pair_gran_bridge.h"
// --
#include "atom.h"
#include "force.h"
#include "neigh_list.h"
#include "update.h"

namespace LAMMPS_NS {

ComputePairGranLocal::ComputePairGranLocal(LAMMPS* host, int narg, char** arg)
    : Compute(host, narg, arg) {
  pairs_ = dynamic_cast<const PairGranBridge*>(force->pair_match("gran/bridge", 1));
  if (pairs_ == nullptr)
    gasgrain::stop_everything(
        "compute pair/gran/local stands after 'pair_style gran/bridge' and its pair_coeff.");
  if (narg < 4 || narg > 5 || std::strcmp(arg[3], "id") != 0 ||
      (narg == 5 && std::strcmp(arg[4], "history") != 0))
    gasgrain::stop_everything(
        "compute pair/gran/local takes the words 'id' or 'id history'; forces, positions and the "
        "like "
        "are given by LAMMPS's own compute pair/local and property/local.");
  with_history_ = narg == 5;
  local_flag = 1;
  size_local_cols = of_id + (with_history_ ? pairs_->history_width() : 0);
}

void ComputePairGranLocal::init() {
  pairs_ = dynamic_cast<const PairGranBridge*>(force->pair_match("gran/bridge", 1));
  if (pairs_ == nullptr || size_local_cols != of_id + (with_history_ ? pairs_->history_width() : 0))
    gasgrain::stop_everything(
        "the pair style has changed since compute pair/gran/local was made: make it anew.");
}

void ComputePairGranLocal::compute_local() {
  invoked_local = update->ntimestep;
  const NeighList& list = *pairs_->list;
  const FixNeighHistory* history = pairs_->history_fix();
  const auto columns = static_cast<std::size_t>(size_local_cols);
  values_.clear();
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n];
    if ((atom->mask[i] & groupbit) == 0) continue;
    for (int m = 0; m < list.numneigh[i]; ++m) {
      const int j = list.firstneigh[i][m] & NEIGHMASK;
      if ((atom->mask[j] & groupbit) == 0) continue;
      // A pair of two ranks, or across a periodic face, is in the lists of both owners.
      if (j >= atom->nlocal && force->newton_pair == 0 && atom->tag[i] > atom->tag[j]) continue;
      double square = 0.0;
      for (int d = 0; d < 3; ++d)
        square += (atom->x[i][d] - atom->x[j][d]) * (atom->x[i][d] - atom->x[j][d]);
      const double touch = atom->radius[i] + atom->radius[j];
      const bool kept = history != nullptr && history->firstflag[i][m] != 0;
      if (square >= touch * touch && !kept) continue;
      const int owned = atom->map(atom->tag[j]);
      const bool across = j >= atom->nlocal && owned >= 0 && owned < atom->nlocal;
      values_.insert(values_.end(), {static_cast<double>(atom->tag[i]),
                                     static_cast<double>(atom->tag[j]), across ? 1.0 : 0.0});
      if (with_history_ && history != nullptr) {
        const int width = pairs_->history_width();
        const double* row = history->firstvalue[i] + static_cast<std::ptrdiff_t>(m) * width;
        values_.insert(values_.end(), row, row + width);
      }
    }
  }
  size_local_rows = static_cast<int>(values_.size() / columns);
  rows_.resize(static_cast<std::size_t>(std::max(1, size_local_rows)));
  for (std::size_t row = 0; row * columns < values_.size(); ++row)
    rows_[row] = values_.data() + row * columns;
  array_local = rows_.data();
}

double ComputePairGranLocal::memory_usage() {
  return static_cast<double>(values_.capacity() * sizeof(double) +
                             rows_.capacity() * sizeof(double*));
}

}  // namespace LAMMPS_NS
