// A tangential dashpot up to Coulomb's limit, without memory: it holds nothing at rest.
//
//   F_t = -min(gamma_t, mu |F_n| / |v_t|) v_t
//
// Source: P.K. Haff, B.T. Werner, Powder Technol. 48 (1986) 239.
// Inputs: mu friction [-]. Output: force on i [N]. Range: mu >= 0.
// Deviations: none from LIGGGHTS's `tangential no_history`.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/tangential_law.h"

namespace gasgrain::contact {

class TangentialNoHistory : public TangentialLaw {
 public:
  static constexpr const char* name = "no_history";

  template <class Real>
  [[gnu::always_inline]] inline TripleOf<Real> touching(const TouchOf<Real>& touch,
                                                        Real* /*stored*/) const {
    const Real speed = touch.slip.norm();
    const Real most = limit(touch);
    const auto slides = most < touch.tangential_damping * speed;
    return -select(slides, most / speed, touch.tangential_damping) * touch.slip;
  }
};

}  // namespace gasgrain::contact
