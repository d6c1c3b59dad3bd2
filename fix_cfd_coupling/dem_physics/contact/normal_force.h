// What normal laws end with: F_n = k_n delta - gamma_n v_n, and the words that change it.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/contact/touch.h"

namespace gasgrain::contact {

template <class Real>
[[gnu::always_inline]] inline void set_normal_force(TouchOf<Real>& touch, bool never_pulls) {
  const Real force = touch.normal_stiffness * touch.overlap - touch.normal_damping * touch.parting;
  touch.normal_force = never_pulls ? select(force < 0.0, Real(0.0), force) : force;
}

}  // namespace gasgrain::contact
