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

  [[gnu::always_inline]] inline Triple touching(const Touch& touch, double* /*stored*/) const {
    const double speed = touch.slip.norm();
    const double most = limit(touch);
    const bool slides = most < touch.tangential_damping * speed;
    return -(slides ? most / speed : touch.tangential_damping) * touch.slip;
  }
};

}  // namespace gasgrain::contact
