// A tangential spring that remembers the slip since the spheres touched, up to Coulomb's limit; a
// dashpot while it sticks.
//
//   s += v_t dt,  s -= (s . n) n
//   F_t = -k_t s - gamma_t v_t           where k_t |s| <= mu |F_n|
//   F_t = -mu |F_n| s / |s|, s = -F_t / k_t   where it slides
//
// Source: P.A. Cundall, O.D.L. Strack, Geotechnique 29 (1979) 47; with Hertz's contact k_t is
//   that of Mindlin without rescaling of s when k_t changes.
// Inputs: mu friction [-]; s [m] in the contact's history, odd under i <-> j. Output: force on i
// [N]. Range: mu >= 0. Deviations: none from LIGGGHTS's `tangential history`: lever arms end at the
// middle of the overlap,
//   and the limit leaves the dashpot out.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/tangential_law.h"

namespace gasgrain::contact {

// The slip of a contact over this step, in the plane in which the spheres touch now.
template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> follow_slip(const TouchOf<Real>& touch,
                                                         const Real* stored) {
  auto slip = TripleOf<Real>::of(stored);
  if (!touch.updates) return slip;
  slip += touch.step * touch.slip;
  return slip - slip.dot(touch.normal) * touch.normal;
}

inline std::vector<HistoryValue> shear_history() {
  return {{"shearx", true}, {"sheary", true}, {"shearz", true}};
}

template <class Real>
[[gnu::always_inline]] inline void store_slip(const TouchOf<Real>& touch,
                                              const TripleOf<Real>& slip, Real* stored) {
  if (!touch.updates) return;
  slip.store(stored);
}

class TangentialHistory : public TangentialLaw {
 public:
  static constexpr const char* name = "history";
  static constexpr int remembers = 3;
  static std::vector<HistoryValue> history() { return shear_history(); }

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> touching(const TouchOf<Real>& touch,
                                                        Real* stored) const {
    TripleOf<Real> slip = follow_slip(touch, stored);
    const Real elastic = touch.tangential_stiffness * slip.norm();
    const Real most = limit(touch);
    TripleOf<Real> force = -touch.tangential_stiffness * slip;
    const auto slides = elastic > most;
    if (any(slides)) {
      const Real share = select(slides, most / elastic, Real(1.0));
      force *= share;
      slip *= share;
    }
    if (any(!slides)) force -= select(slides, Real(0.0), touch.tangential_damping) * touch.slip;
    store_slip(touch, slip, stored);
    return force;
  }
};

}  // namespace gasgrain::contact
