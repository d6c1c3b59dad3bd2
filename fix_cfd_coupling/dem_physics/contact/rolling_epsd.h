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
template <class Real>
[[gnu::always_inline]] inline auto wind_up(const TouchOf<Real>& touch, const Real& stiffness,
                                           const TripleOf<Real>& turning, const Real& limit,
                                           const Real* stored, TripleOf<Real>& torque) {
  torque = TripleOf<Real>::of(stored) + touch.step * stiffness * turning;
  const Real size = torque.norm();
  const auto slips = size > limit;
  torque *= select(slips, limit / size, Real(1.0));
  return !slips;
}

class RollingEpsd : public RollingResistance {
 public:
  static constexpr const char* name = "epsd";
  static constexpr int remembers = 3;
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return torque_history(); }

  void connect(ContactHost& host) {
    RollingResistance::connect(host);
    damping_ = pairs_in(host, properties::rolling_damping);
  }

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> torque(const TouchOf<Real>& touch,
                                                      Real* stored) const {
    using std::abs, std::sqrt;
    const Real lever = friction(touch) * touch.reduced_radius;
    const Real stiffness = 2.25 * touch.normal_stiffness * lever * lever;
    const TripleOf<Real> turning = rolling(touch);
    TripleOf<Real> torque;
    const auto holds =
        wind_up<Real>(touch, stiffness, turning, lever * abs(touch.normal_force), stored, torque);
    if (touch.updates) torque.store(stored);
    const Real dashpot = 2.0 * damping_[touch.types] * sqrt(inertia(touch) * stiffness);
    torque += select(holds, dashpot, Real(0.0)) * turning;
    return -torque;
  }

 private:
  template <class Real>
  [[gnu::always_inline]] static inline Real inertia(const TouchOf<Real>& touch) {
    const Real of_i = touch.mass_i * touch.radius_i * touch.radius_i;
    if (touch.is_wall) return 1.4 * of_i;
    const Real of_j = touch.mass_j * touch.radius_j * touch.radius_j;
    return 1.4 * of_i * of_j / (of_i + of_j);
  }
  PairTable<double> damping_;  // eta_r
};

}  // namespace gasgrain::contact
