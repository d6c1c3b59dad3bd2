// What a law of rolling friction is, as cohesion_law.h: connect(), and touching() after the
// tangential model, which adds torques. A wall does not turn.
//
// RollingByTypes is a law without a state of its own whose constants go with the two types.
#pragma once

#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/rolling/relative_rolling.h"

namespace gasgrain::contact {

class RollingLaw {
 public:
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return {}; }
  static constexpr int remembers = 0;  // how many values its history has
  void words(LawWords&) {}
  void apart(ContactView&, const ContactForces&) {}
};

class RollingOff : public RollingLaw {
 public:
  void connect(ContactHost&) {}
  void touching(ContactView&, const ContactForces&) {}
};

// Law::torque(rolling, normal force, reduced radius) is that on i.
template <class Law>
class RollingByTypes : public RollingLaw {
 public:
  void touching(ContactView& c, const ContactForces& f) {
    const Vec3 spin_j = c.is_wall ? Vec3(0.0, 0.0, 0.0) : vec(c.omega_j);
    const Vec3 rolling = rolling::relative_rolling(vec(c.omega_i), spin_j, vec(c.en));
    const Vec3 torque = laws_(c.itype, c.jtype).torque(rolling, c.Fn, c.reduced_radius());
    for (int d = 0; d < 3; ++d) {
      f.torque_i[d] += torque[d] * (c.is_wall ? c.area_ratio : 1.0);
      if (!c.is_wall) f.torque_j[d] -= torque[d];
    }
  }

 protected:
  PairTable<Law> laws_;
};

}  // namespace gasgrain::contact
