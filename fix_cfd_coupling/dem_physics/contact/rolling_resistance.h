// What LIGGGHTS's models of rolling friction share: torque(touch, stored) on i [N m], on j the
// opposite one; the word torsionTorque; and how one body turns on the other, which is the
// difference of spins of two spheres, of a sphere on a wall its spin times lever arm over distance.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/property_range.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_law.h"
#include "fix_cfd_coupling/dem_physics/contact/touch.h"

namespace gasgrain::contact {

template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> turning_of(const TouchOf<Real>& touch) {
  if (touch.is_wall) return touch.lever_i / touch.distance * touch.spin_i;
  return touch.spin_i - touch.spin_j;
}

template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> across(const TripleOf<Real>& vector,
                                                    const TripleOf<Real>& normal) {
  return vector - vector.dot(normal) * normal;
}

class RollingResistance : public RollingLaw {
 public:
  void words(LawWords& words) { words.on_off("torsionTorque", torsion_, false); }
  void connect(ContactHost& host) { friction_ = pairs_in(host, properties::rolling_friction); }

 protected:
  template <class Real>
  [[nodiscard]] [[gnu::always_inline]] inline double friction(const TouchOf<Real>& touch) const {
    return friction_[touch.types];
  }
  template <class Real>
  [[nodiscard]] [[gnu::always_inline]] inline TripleOf<Real> rolling(
      const TouchOf<Real>& touch) const {
    const TripleOf<Real> turning = turning_of(touch);
    return torsion_ ? turning : across(turning, touch.normal);
  }
  bool torsion_ = false;

 private:
  PairTable<double> friction_;  // mu_r
};

inline std::vector<HistoryValue> torque_history() {
  return {{"r_torquex_old", true}, {"r_torquey_old", true}, {"r_torquez_old", true}};
}

}  // namespace gasgrain::contact
