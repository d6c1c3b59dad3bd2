// compute ID GROUP pair/gran/local id [history]
//
// The pairs of `pair_style gran/bridge` that touch, or whose laws act at a distance (a bridge, a
// neck): a row each, once, both grains in the group. Columns as of LIGGGHTS's compute of this name:
// the numbers of both grains and whether the contact is across a periodic face (1) or not (0); with
// `history` what the laws keep of the contact, in SI, as the first grain of the row sees it.
#pragma once

#include <vector>

#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "compute.h"

namespace LAMMPS_NS {

class PairGranBridge;

class ComputePairGranLocal : public Compute {
 public:
  ComputePairGranLocal(LAMMPS* host, int narg, char** arg);

  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  static constexpr int of_id = 3;  // columns

  const PairGranBridge* pairs_ = nullptr;
  bool with_history_ = false;
  std::vector<double> values_;
  std::vector<double*> rows_;
};

}  // namespace LAMMPS_NS
