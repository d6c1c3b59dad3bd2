// Hertz's contact of elastic spheres, with a damping that gives one coefficient of restitution
// whatever the speed, and Mindlin's tangential stiffness.
//
//   F_n = k_n delta - gamma_n v_n      k_n = 4/3 E* sqrt(R* delta)     k_t = 8 G* sqrt(R* delta)
//   gamma_n = 2 sqrt(5/6) zeta sqrt(S_n m*)    S_n = 2 E* sqrt(R* delta)
//   gamma_t = 2 sqrt(5/6) zeta sqrt(k_t m*)
//   1/E* = (1 - nu_i^2) / E_i + (1 - nu_j^2) / E_j
//   1/G* = 2 (2 - nu_i) (1 + nu_i) / E_i + 2 (2 - nu_j) (1 + nu_j) / E_j
//   zeta = -ln e / sqrt(ln^2 e + pi^2)
//
// Sources: H. Hertz (1881); R.D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327; Y. Tsuji,
//   T. Tanaka, T. Ishida, Powder Technol. 71 (1992) 239; A. Di Renzo, F.P. Di Maio, Chem. Eng. Sci.
//   59 (2004) 525.
// Inputs: E Young's modulus [Pa], nu Poisson's ratio, e restitution. k_n, k_t are secants [N/m].
// Assumes delta << R*. Range: E > 0, 0 <= nu <= 0.5, 0 < e <= 1.
// Words: tangential_damping on (off: gamma_t = 0), limitForce off (on: F_n is never below 0).
// Deviations: none from LIGGGHTS's `model hertz`, whose numbers these are.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/normal_force.h"
#include "fix_cfd_coupling/dem_physics/contact/property_range.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::contact {

class NormalHertz {
 public:
  static constexpr const char* name = "hertz";

  struct Pair {
    double stiffness = 0.0;         // 4/3 E*
    double shear_stiffness = 0.0;   // 8 G*
    double damping = 0.0;           // gamma_n = damping sqrt(sqrt(R* delta) m*)
    double shear_of_damping = 0.0;  // gamma_t / gamma_n
  };

  void words(LawWords& words) {
    words.on_off("tangential_damping", tangential_damping_, true);
    words.on_off("limitForce", never_pulls_, false);
  }
  void connect(ContactHost& host) {
    const auto youngs = per_type_in(host, properties::youngs_modulus);
    const auto poisson = per_type_in(host, properties::poissons_ratio);
    const auto restitution = pairs_in(host, properties::restitution);
    pairs_ = table_of(host.types(), [&](int i, int j) {
      return pair_of(youngs[i], poisson[i], youngs[j], poisson[j], restitution(i, j));
    });
  }

  template <class Real>
  [[gnu::always_inline]] inline void touching(TouchOf<Real>& touch) const {
    using std::sqrt;
    const Pair& pair = pairs_[touch.types];
    const Real patch = sqrt(touch.reduced_radius * touch.overlap);  // radius of contact
    touch.normal_stiffness = pair.stiffness * patch;
    touch.tangential_stiffness = pair.shear_stiffness * patch;
    touch.normal_damping = pair.damping * sqrt(patch * touch.reduced_mass);
    touch.tangential_damping = pair.shear_of_damping * touch.normal_damping;
    set_normal_force(touch, never_pulls_);
  }

 private:
  static double reduced_shear_modulus(double youngs_i, double poisson_i, double youngs_j,
                                      double poisson_j) {
    return 1.0 / (2.0 * (2.0 - poisson_i) * (1.0 + poisson_i) / youngs_i +
                  2.0 * (2.0 - poisson_j) * (1.0 + poisson_j) / youngs_j);
  }
  [[nodiscard]] Pair pair_of(double youngs_i, double poisson_i, double youngs_j, double poisson_j,
                             double restitution) const {
    const double modulus = effective_modulus(youngs_i, poisson_i, youngs_j, poisson_j);
    const double shear = reduced_shear_modulus(youngs_i, poisson_i, youngs_j, poisson_j);
    const double damping = 2.0 * std::sqrt(5.0 / 6.0) * damping_ratio(restitution);
    return {4.0 / 3.0 * modulus, 8.0 * shear, damping * std::sqrt(2.0 * modulus),
            tangential_damping_ ? 2.0 * std::sqrt(shear / modulus) : 0.0};
  }
  bool tangential_damping_ = true;
  bool never_pulls_ = false;
  PairTable<Pair> pairs_;
};

}  // namespace gasgrain::contact
