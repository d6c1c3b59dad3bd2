// The pressure of gas at rest, which the solver keeps apart from the pressure it solves for:
//   p_rest(x) = p_out + rho g . (x - x_out),
// x_out being the centre of the first outlet (of the top when there is none). With p = p_rest + p'
// the balance -eps grad p + eps rho g is -eps grad p' alone: gas at rest has p' = 0 exactly, in any
// field of void fraction, and an outlet of any direction has p' = 0.
//
// Along a periodic axis no such pressure exists; gravity there stays a body force (what drives a
// periodic channel).
#pragma once

#include "gas_solver/gas_input.h"

namespace gasgrain {

class Hydrostatic {
 public:
  explicit Hydrostatic(const GasInput& input) : grid_(input.grid), base_(input.outlet_pressure) {
    for (int d = 0; d < 3; ++d) {
      (grid_.periodic[d] ? body_force_ : gradient_)[d] = input.density * input.gravity[d];
      reference_[d] = 0.5 * (grid_.lo[d] + grid_.hi[d]);
    }
    int side = side_of(2, true);
    for (int n = side_count - 1; n >= 0; --n)
      if (input.sides[n] == &outlet) side = n;
    reference_[axis_of(side)] = is_high(side) ? grid_.hi[axis_of(side)] : grid_.lo[axis_of(side)];
  }

  // At the centre of a cell [Pa].
  [[nodiscard]] double pressure(int i, int j, int k) const {
    const Vec3 center = grid_.lo + grid_.spacing().cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
    return base_ + gradient_.dot(center - reference_);
  }
  [[nodiscard]] const Vec3& gradient() const { return gradient_; }      // [Pa/m]
  [[nodiscard]] const Vec3& body_force() const { return body_force_; }  // per gas volume [N/m3]

 private:
  BoxGrid grid_;
  double base_;
  Vec3 reference_;
  Vec3 gradient_ = Vec3::Zero();
  Vec3 body_force_ = Vec3::Zero();
};

}  // namespace gasgrain
