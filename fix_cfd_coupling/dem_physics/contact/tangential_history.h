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
inline Triple follow_slip(const Touch& touch, const double* stored) {
  Triple slip = Triple::of(stored);
  if (!touch.updates) return slip;
  slip += touch.step * touch.slip;
  return slip - slip.dot(touch.normal) * touch.normal;
}

inline std::vector<HistoryValue> shear_history() {
  return {{"shearx", true}, {"sheary", true}, {"shearz", true}};
}

inline void store_slip(const Touch& touch, const Triple& slip, double* stored) {
  if (!touch.updates) return;
  slip.store(stored);
}

class TangentialHistory : public TangentialLaw {
 public:
  static constexpr const char* name = "history";
  static constexpr bool remembers = true;
  static std::vector<HistoryValue> history() { return shear_history(); }

  [[gnu::always_inline]] inline Triple touching(const Touch& touch, double* stored) const {
    Triple slip = follow_slip(touch, stored);
    const double elastic = touch.tangential_stiffness * slip.norm();
    const double most = limit(touch);
    Triple force = -touch.tangential_stiffness * slip;
    if (elastic > most) {
      const double share = most / elastic;
      force *= share;
      slip *= share;
    } else {
      force -= touch.tangential_damping * touch.slip;
    }
    store_slip(touch, slip, stored);
    return force;
  }
};

}  // namespace gasgrain::contact
