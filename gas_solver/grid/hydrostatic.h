// The pressure of gas at rest, which the solver keeps apart from the pressure it solves for:
// p = p_rest + p'. Gas at rest has p' = 0 exactly, in any field of void fraction, and an outlet of
// any direction has p' = 0.
//
//   constant density:  p_rest(x) = p_out + rho g . (x - x_out)
//   ideal gas:         p_rest(x) = P_out * product over the axes of q^n - P_ref,
//                      q = (1 + a / 2) / (1 - a / 2),  a = M g h / (R T),  n = (x - x_out) / h
// x_out is the centre of the first outlet (of the top when there is none), P_ref the absolute
// pressure of gauge 0, P_out that at the outlet. The second is the isothermal atmosphere as the
// grid sees it: (p_k+1 - p_k) / h = (rho_k + rho_k+1) / 2 g holds to round-off.
//
// With it, -eps grad p + eps rho g is -eps grad p' + eps rho' g, rho' = p' M / (R T) (0 at constant
// density).
//
// Along a periodic axis no such pressure exists; gravity there stays a body force (what drives a
// periodic channel).
#pragma once

#include "gas_solver/gas_input.h"

namespace gasgrain {

class Hydrostatic {
 public:
  explicit Hydrostatic(const GasInput& input);

  // Gauge pressure at the centre of a cell [Pa].
  [[nodiscard]] double pressure(int i, int j, int k) const;
  // Of the gas at rest [kg/m3].
  [[nodiscard]] double density(int i, int j, int k) const {
    return compressibility_ > 0 ? (pressure(i, j, k) + reference_pressure_) * compressibility_
                                : density_;
  }
  // d rho / dp [s2/m2]; 0 at constant density.
  [[nodiscard]] double compressibility() const { return compressibility_; }
  // Gravity along the axes that are not periodic, and along those that are [m/s2].
  [[nodiscard]] const Vec3& gravity_at_rest() const { return gravity_at_rest_; }
  [[nodiscard]] const Vec3& gravity_body() const { return gravity_body_; }

 private:
  BoxGrid grid_;
  double density_;
  double compressibility_;
  double reference_pressure_;
  double outlet_pressure_;
  Vec3 reference_;
  Vec3 gravity_at_rest_ = Vec3::Zero();
  Vec3 gravity_body_ = Vec3::Zero();
  Vec3 growth_ = Vec3::Ones();  // q of each axis
};

}  // namespace gasgrain
