// Rolling resistance by an elastic-plastic spring that remembers the rotation, and a dashpot while
// it holds.
//
//   w_t = w - (w . n) n,  w = w_i - w_j       k_r = 9/4 k_n (mu_r R*)^2
//   T += k_r w_t dt, |T| <= mu_r R* |F_n|
//   M_i = -T - C_r w_t where |T| is below the limit, else -T      C_r = 2 eta_r sqrt(I_r k_r)
//   I_r = 7/5 of m_i R_i^2 m_j R_j^2 / (m_i R_i^2 + m_j R_j^2); at a wall 7/5 m_i R_i^2
//
// Source: K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285; J. Ai et al., Powder
//   Technol. 206 (2011) 269, model C.
// Inputs: mu_r, eta_r [-]; T [N m] in the contact's history, odd under i <-> j. Output: torque on i
//   [N m]; on j the opposite one. Range: mu_r, eta_r >= 0.
// Word: torsionTorque off (on: w_t = w). Assumes three dimensions.
// Deviations: none from LIGGGHTS's `rolling_friction epsd`.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/rolling_resistance.h"

namespace gasgrain::contact {

// The spring's torque after this step, at most `limit` [N m]; true where it is below.
inline bool wind_up(const Touch& touch, double stiffness, const Triple& turning, double limit,
                    const double* stored, Triple& torque) {
  torque = Triple::of(stored) + touch.step * stiffness * turning;
  const double size = torque.norm();
  if (!(size > limit)) return true;
  torque *= limit / size;
  return false;
}

class RollingEpsd : public RollingResistance {
 public:
  static constexpr const char* name = "epsd";
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return torque_history(); }

  void connect(ContactHost& host) {
    RollingResistance::connect(host);
    damping_ = pairs_in(host, properties::rolling_damping);
  }

  [[gnu::always_inline]] inline Triple torque(const Touch& touch, double* stored) const {
    const double lever = friction(touch) * touch.reduced_radius;
    const double stiffness = 2.25 * touch.normal_stiffness * lever * lever;
    const Triple turning = rolling(touch);
    Triple torque;
    const bool holds =
        wind_up(touch, stiffness, turning, lever * std::abs(touch.normal_force), stored, torque);
    if (touch.updates) torque.store(stored);
    if (holds)
      torque += damping_[touch.types] * 2.0 * std::sqrt(inertia(touch) * stiffness) * turning;
    return -torque;
  }

 private:
  static double inertia(const Touch& touch) {
    const double of_i = touch.mass_i * touch.radius_i * touch.radius_i;
    if (touch.is_wall) return 1.4 * of_i;
    const double of_j = touch.mass_j * touch.radius_j * touch.radius_j;
    return 1.4 * of_i * of_j / (of_i + of_j);
  }
  PairTable<double> damping_;  // eta_r
};

}  // namespace gasgrain::contact
