// Hertz's contact with stiffness and damping given as they stand in the force.
//
//   F_n = a (K_n delta - m* g_n v_n)    k_t = a K_t    gamma_t = a m* g_t    a = sqrt(R* delta)
//
// Sources: N.V. Brilliantov, F. Spahn, J.-M. Hertzsch, T. Poeschel, Phys. Rev. E 53 (1996) 5382;
//   L.E. Silbert et al., Phys. Rev. E 64 (2001) 051302.
// Inputs: K_n, K_t [Pa], g_n, g_t [1/(m s)]. Range: from 0.
// Words: tangential_damping on (off: gamma_t = 0), limitForce off (on: F_n is never below 0).
// Deviations: none from LIGGGHTS's `model hertz/stiffness`; it is the normal force of LAMMPS's
//   `gran/hertz/history` too.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/normal_force.h"
#include "fix_cfd_coupling/dem_physics/contact/property_range.h"

namespace gasgrain::contact {

// Of hertz/stiffness and hooke/stiffness.
struct StiffnessPair {
  double normal = 0.0, tangential = 0.0;                  // K_n, K_t
  double normal_damping = 0.0, tangential_damping = 0.0;  // g_n, g_t
};

inline PairTable<StiffnessPair> stiffness_pairs(const ContactHost& host,
                                                const PropertyRange& normal,
                                                const PropertyRange& tangential,
                                                const PropertyRange& normal_damping,
                                                const PropertyRange& tangential_damping,
                                                bool damps_tangentially) {
  const auto k_n = pairs_in(host, normal);
  const auto k_t = pairs_in(host, tangential);
  const auto g_n = pairs_in(host, normal_damping);
  const auto g_t = pairs_in(host, tangential_damping);
  return table_of(host.types(), [&](int i, int j) {
    return StiffnessPair{k_n(i, j), k_t(i, j), g_n(i, j), damps_tangentially ? g_t(i, j) : 0.0};
  });
}

class NormalHertzStiffness {
 public:
  static constexpr const char* name = "hertz/stiffness";

  void words(LawWords& words) {
    words.on_off("tangential_damping", tangential_damping_, true);
    words.on_off("limitForce", never_pulls_, false);
  }
  void connect(ContactHost& host) {
    pairs_ = stiffness_pairs(host, {"kn", "Pa"}, {"kt", "Pa"}, {"gamman", "1/(m s)"},
                             {"gammat", "1/(m s)"}, tangential_damping_);
  }

  template <class Real>
  [[gnu::always_inline]] inline void touching(TouchOf<Real>& touch) const {
    using std::sqrt;
    const StiffnessPair& pair = pairs_[touch.types];
    const Real patch = sqrt(touch.reduced_radius * touch.overlap);
    const Real mass = patch * touch.reduced_mass;
    touch.normal_stiffness = patch * pair.normal;
    touch.tangential_stiffness = patch * pair.tangential;
    touch.normal_damping = mass * pair.normal_damping;
    touch.tangential_damping = mass * pair.tangential_damping;
    set_normal_force(touch, never_pulls_);
  }

 private:
  bool tangential_damping_ = true;
  bool never_pulls_ = false;
  PairTable<StiffnessPair> pairs_;
};

}  // namespace gasgrain::contact
