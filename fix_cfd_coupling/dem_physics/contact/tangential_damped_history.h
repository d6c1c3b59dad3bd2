// The tangential spring of LAMMPS's own granular styles: spring and dashpot together are held to
// Coulomb's limit, and lever arms are the radii.
//
//   s += v_t dt,  s -= (s . n) n,  F = -k_t s - gamma_t v_t
//   F_t = F                                 where |F| <= mu |F_n|
//   F_t = mu |F_n| F / |F|, s = (-F_t - gamma_t v_t) / k_t    where it slides; 0 where s was 0
//
// Source: L.E. Silbert et al., Phys. Rev. E 64 (2001) 051302; documentation of LAMMPS, pair_style
//   gran/hertz/history.
// Inputs, outputs, range: as tangential_history.h.
// Deviations: none from gran/hooke/history and gran/hertz/history of LAMMPS 29 Sep 2021; as there,
//   the history follows sliding even where forces are only looked at.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/tangential_history.h"

namespace gasgrain::contact {

class TangentialDampedHistory : public TangentialLaw {
 public:
  static constexpr const char* name = "damped_history";
  static constexpr int remembers = 3;
  static std::vector<HistoryValue> history() { return shear_history(); }
  static constexpr bool levers_are_radii = true;

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> touching(const TouchOf<Real>& touch,
                                                        Real* stored) const {
    const TripleOf<Real> slip = follow_slip(touch, stored);
    const TripleOf<Real> dashpot = touch.tangential_damping * touch.slip;
    TripleOf<Real> force = -touch.tangential_stiffness * slip - dashpot;
    const Real size = force.norm();
    const Real most = limit(touch);
    store_slip(touch, slip, stored);
    const auto slides = size > most;
    if (!any(slides)) return force;
    const auto new_slip = slip.is_zero();  // nothing to go by: neither force nor spring
    force *= select(slides, select(new_slip, Real(0.0), most / size), Real(1.0));
    const TripleOf<Real> held = (1.0 / touch.tangential_stiffness) * (-force - dashpot);
    select(slides & !new_slip, held, TripleOf<Real>::of(stored)).store(stored);
    return force;
  }
};

}  // namespace gasgrain::contact
