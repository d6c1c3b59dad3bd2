// One normal, one tangential, one rolling and one cohesion law made into one: what they do to a
// contact, in the order in which each needs the others' results.
//
// Normal force, cohesion (it may change what friction's limit goes by), friction, rolling
// resistance, and after all of them what cohesion does last. Bodies that are apart have cohesion
// alone. The laws are members, and their calls are inlined into the loop (contact_loop.h).
#pragma once

#include <type_traits>

#include "fix_cfd_coupling/dem_physics/contact/contact_arrays.h"
#include "fix_cfd_coupling/dem_physics/contact/primitive_wall.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_resistance.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_law.h"

namespace gasgrain::contact {

// Forces [N] and torques [N m] that a contact adds to its two bodies. Without cohesion force_j is
// not written: it is -force_i.
struct Push {
  Triple force_i, torque_i, torque_j, force_j;
};

// Where each law's values begin in a row of a contact's history: friction's, then those of rolling
// up to touch_end; cohesion's after or before them.
struct HistoryPlaces {
  int tangential = 0, rolling = 0, touch_end = 0, cohesion = 0, width = 0;
};

// Whether a normal law has prepare(R*, m*, types): what of it is found for one contact at a time.
template <class Normal, class = void>
inline constexpr bool prepares = false;
template <class Normal>
inline constexpr bool prepares<Normal, std::void_t<decltype(&Normal::prepare)>> = true;

template <class Normal, class Tangential, class Rolling, class Cohesion>
class ContactLaws {
 public:
  static constexpr bool has_rolling = !std::is_same_v<Rolling, RollingOff>;
  static constexpr bool has_cohesion = !std::is_same_v<Cohesion, CohesionOff>;
  static constexpr bool levers_are_radii = Tangential::levers_are_radii;
  // Values of friction and rolling.
  static constexpr int remembered = Tangential::remembers + Rolling::remembers;
  // Whether several contacts can be computed at once.
  static constexpr bool fit_lanes =
      !has_cohesion && (!has_rolling || std::is_base_of_v<RollingResistance, Rolling>);
  static constexpr bool remembers_touch = Tangential::remembers > 0;

  Normal normal;
  Tangential tangential;
  Rolling rolling;
  Cohesion cohesion;
  HistoryPlaces places;

  // Bodies in touch; `view` is complete but for what the normal law says. `velocity` of i from j.
  // `row` may be null where no law has a history.
  [[gnu::always_inline]] inline void touching(Touch& touch, const Triple& velocity,
                                              ContactView& view, double* row, Push& push) {
    find_motion<levers_are_radii>(touch, velocity);
    if constexpr (prepares<Normal>)
      touch.prepared = normal.prepare(touch.reduced_radius, touch.reduced_mass, touch.types);
    normal.touching(touch);
    const Triple along = touch.normal_force * touch.normal;
    [[maybe_unused]] const ContactForces forces = forces_of(push);
    if constexpr (has_cohesion) {
      show(touch, view, row);
      cohesion.touching(view, forces);
      touch.normal_force = view.Fn;
    }
    const Triple friction = tangential.touching(touch, row + places.tangential);
    const Triple twist = cross(friction, touch.normal);
    const Triple force = along + friction;
    if constexpr (has_cohesion) {
      push.force_i += force;
      push.force_j -= force;
      push.torque_i += touch.lever_i * twist;
      push.torque_j += touch.lever_j * twist;
    } else {  // nothing was there before
      push.force_i = force;
      push.torque_i = touch.lever_i * twist;
      push.torque_j = touch.lever_j * twist;
    }
    if constexpr (std::is_base_of_v<RollingResistance, Rolling>) {
      const Triple torque = rolling.torque(touch, row + places.rolling);
      push.torque_i += torque;
      push.torque_j -= torque;
    } else if constexpr (has_rolling) {
      show(touch, view, row);
      view.history = row == nullptr ? nullptr : row + places.rolling;
      rolling.touching(view, forces);
    }
    if constexpr (has_cohesion) {
      view.history = row == nullptr ? nullptr : row + places.cohesion;
      cohesion.after_all(view, forces);
    }
  }

  // Several pairs of grains of the same two types at once, Real being Lanes (lanes.h), for laws
  // that need no view. `stored` are friction's values and those of rolling.
  template <class Real>
  [[gnu::always_inline]] inline void touching_in_lanes(TouchOf<Real>& touch,
                                                       const TripleOf<Real>& velocity, Real* stored,
                                                       TripleOf<Real>& force,
                                                       TripleOf<Real>& torque_i,
                                                       TripleOf<Real>& torque_j) const {
    find_motion<levers_are_radii>(touch, velocity);
    normal.touching(touch);
    const TripleOf<Real> friction = tangential.touching(touch, stored);
    const TripleOf<Real> twist = cross(friction, touch.normal);
    force = touch.normal_force * touch.normal + friction;
    torque_i = touch.lever_i * twist;
    torque_j = touch.lever_j * twist;
    if constexpr (has_rolling) {
      const TripleOf<Real> resistance = rolling.torque(touch, stored + Tangential::remembers);
      torque_i += resistance;
      torque_j -= resistance;
    }
  }

  // Bodies that are apart; whether a force acts.
  bool apart(ContactView& view, double* row, Push& push) {
    if constexpr (has_cohesion) {
      view.history = row == nullptr ? nullptr : row + places.cohesion;
      view.acts = false;
      cohesion.apart(view, forces_of(push));
      return view.acts;
    } else {
      return false;
    }
  }

  // What friction and rolling remember ends when the bodies part.
  [[gnu::always_inline]] inline void forget_touch(double* row) const {
    for (int n = places.tangential; n < places.touch_end; ++n) row[n] = 0.0;
  }

 private:
  static ContactForces forces_of(Push& push) {
    return {push.force_i.data(), push.torque_i.data(), push.force_j.data(), push.torque_j.data()};
  }
  void show(const Touch& touch, ContactView& view, double* row) const {
    view.history = row == nullptr ? nullptr : row + places.cohesion;
    view.en = touch.normal.data();
    view.overlap = touch.overlap;
    view.vn = touch.parting;
    view.meff = touch.reduced_mass;
    view.kn = touch.normal_stiffness;
    view.kt = touch.tangential_stiffness;
    view.Fn = touch.normal_force;
  }
};

}  // namespace gasgrain::contact
