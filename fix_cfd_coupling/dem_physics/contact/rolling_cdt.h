// Rolling resistance by a torque of constant size against the rotation.
//
//   M_i = -mu_r k_n delta R* w / |w|, without its part along n;   w = w_i - w_j
//
// Source: J. Ai, J.-F. Chen, J.M. Rotter, J.Y. Ooi, Powder Technol. 206 (2011) 269, model A.
// Inputs: mu_r [-]. Output: torque on i [N m]; on j the opposite one. Range: mu_r >= 0.
// Word: torsionTorque off (on: the part along n stays).
// Deviations: none from LIGGGHTS's `rolling_friction cdt`: the elastic part of F_n alone counts,
//   and w keeps its part along n where it is normed.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/rolling_resistance.h"

namespace gasgrain::contact {

class RollingCdt : public RollingResistance {
 public:
  static constexpr const char* name = "cdt";

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> torque(const TouchOf<Real>& touch,
                                                      Real* /*stored*/) const {
    const TripleOf<Real> turning = turning_of(touch);
    const Real rate = turning.norm();
    const Real size = select(
        rate > 0.0,
        friction(touch) * touch.normal_stiffness * touch.overlap * touch.reduced_radius / rate,
        Real(0.0));
    const TripleOf<Real> torque = -size * turning;
    return torsion_ ? torque : across(torque, touch.normal);
  }
};

}  // namespace gasgrain::contact
