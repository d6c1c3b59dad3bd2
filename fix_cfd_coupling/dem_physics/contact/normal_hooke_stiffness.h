// A linear spring and dashpot, given as they stand in the force.
//
//   F_n = K_n delta - m* g_n v_n       k_t = K_t     gamma_t = m* g_t
//   `absolute_damping`: gamma_n = g_n, gamma_t = g_t
//
// Sources: P.A. Cundall, O.D.L. Strack, Geotechnique 29 (1979) 47; L.E. Silbert et al., Phys. Rev.
// E
//   64 (2001) 051302.
// Inputs: K_n, K_t [N/m], g_n, g_t [1/s]; with absolute_damping [N s/m]. Range: from 0.
// Words: tangential_damping on, limitForce off, absolute_damping off.
// Deviations: none from LIGGGHTS's `model hooke/stiffness`; it is the normal force of LAMMPS's
//   `gran/hooke/history` too.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/normal_hertz_stiffness.h"

namespace gasgrain::contact {

class NormalHookeStiffness {
 public:
  static constexpr const char* name = "hooke/stiffness";

  void words(LawWords& words) {
    words.on_off("tangential_damping", tangential_damping_, true);
    words.on_off("absolute_damping", absolute_damping_, false);
    words.on_off("limitForce", never_pulls_, false);
  }
  void connect(ContactHost& host) {
    const PropertyRange normal_damping =
        absolute_damping_ ? PropertyRange{"gamman_abs", "N s/m"} : PropertyRange{"gamman", "1/s"};
    const PropertyRange tangential_damping =
        absolute_damping_ ? PropertyRange{"gammat_abs", "N s/m"} : PropertyRange{"gammat", "1/s"};
    pairs_ = stiffness_pairs(host, {"kn", "N/m"}, {"kt", "N/m"}, normal_damping, tangential_damping,
                             tangential_damping_);
  }

  template <class Real>
  [[gnu::always_inline]] inline void touching(TouchOf<Real>& touch) const {
    const StiffnessPair& pair = pairs_[touch.types];
    const Real mass = absolute_damping_ ? Real(1.0) : touch.reduced_mass;
    touch.normal_stiffness = pair.normal;
    touch.tangential_stiffness = pair.tangential;
    touch.normal_damping = mass * pair.normal_damping;
    touch.tangential_damping = mass * pair.tangential_damping;
    set_normal_force(touch, never_pulls_);
  }

 private:
  bool tangential_damping_ = true;
  bool never_pulls_ = false;
  bool absolute_damping_ = false;
  PairTable<StiffnessPair> pairs_;
};

}  // namespace gasgrain::contact
