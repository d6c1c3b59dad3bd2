// The turbulence of the gas that flows in, and of the gas at rest before and around the domain.
//
//   k = 3/2 (I U)^2,  e = C_mu^(3/4) k^(3/2) / l
//
// I is the intensity, U the true velocity in the opening, l the length scale: [turbulence]
// length_scale, or 0.07 of the patch's hydraulic diameter 4 A / P (Versteeg and Malalasekera 2007,
// section 3.7.2, after a pipe's mixing length). An axis of one cell counts as endless: a patch
// across it is a slot, whose hydraulic diameter is twice its width.
//
// The ambient turbulence is that of the start and of backflow through outlets: weak, mu_t = 10 mu,
// but as fast as the fastest inflow, e/k = U / (4 A / P). From k = 0 the model could never grow
// any. Slow turbulence would be worse: in shear S much faster than e/k the model lets k grow by
// about (0.2 S k/e)^2.3 before e catches up, so that a jet that starts in gas of a large k/e drowns
// in its own mu_t for a while. Without inflow the length is 0.07 of the least distance between
// opposite sides, which gives e/k.
#pragma once

#include <vector>

#include "gas_solver/gas_input.h"

namespace gasgrain {

struct TurbulentValues {
  double k = 0;  // [m2/s2]
  double e = 0;  // [m2/s3]
};

class InflowTurbulence {
 public:
  explicit InflowTurbulence(const GasInput& input);

  [[nodiscard]] const TurbulentValues& ambient() const { return ambient_; }
  // Updates the values of the faces, in their order, which must not change.
  void update(const std::vector<InflowFace>& faces);
  [[nodiscard]] const std::vector<double>& k() const { return k_; }
  [[nodiscard]] const std::vector<double>& e() const { return e_; }

 private:
  [[nodiscard]] double length_at(const InflowFace& face) const;

  BoxGrid grid_;
  TurbulenceInput choice_;
  std::vector<InflowPatch> patches_;
  TurbulentValues ambient_;
  std::vector<double> length_;
  std::vector<double> k_;
  std::vector<double> e_;
};

}  // namespace gasgrain
