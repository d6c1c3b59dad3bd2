// Rolling resistance by an elastic-plastic spring as stiff as the tangential one, without a
// dashpot.
//
//   T += k_t R*^2 w_t dt, |T| <= mu_r R* |F_n|      M_i = -T       w_t as in rolling_epsd.h
//
// Source: K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285, to whom LIGGGHTS's documentation (gran
//   rolling_friction epsd2) ascribes it.
// Inputs: mu_r [-]; T [N m] in the contact's history, odd under i <-> j. Output: torque on i [N m];
//   on j the opposite one. Range: mu_r >= 0.
// Word: torsionTorque off (on: w_t = w).
// Deviations: none from LIGGGHTS's `rolling_friction epsd2`.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/rolling_epsd.h"

namespace gasgrain::contact {

class RollingEpsd2 : public RollingResistance {
 public:
  static constexpr const char* name = "epsd2";
  static constexpr int remembers = 3;
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return torque_history(); }

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> torque(const TouchOf<Real>& touch,
                                                      Real* stored) const {
    using std::abs;
    const Real radius = touch.reduced_radius;
    const TripleOf<Real> turning = rolling(touch);
    TripleOf<Real> torque;
    wind_up<Real>(touch, touch.tangential_stiffness * radius * radius, turning,
                  friction(touch) * radius * abs(touch.normal_force), stored, torque);
    if (touch.updates) torque.store(stored);
    return -torque;
  }
};

}  // namespace gasgrain::contact
