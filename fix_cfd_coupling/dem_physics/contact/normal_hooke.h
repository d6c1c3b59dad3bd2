// A linear spring as stiff as Hertz's contact is on average in a collision at a characteristic
// speed, with a dashpot for one coefficient of restitution.
//
//   F_n = k_n delta - gamma_n v_n      k_n = 16/15 sqrt(R*) E* (15 m* V^2 / (16 sqrt(R*) E*))^(1/5)
//   gamma_n = sqrt(4 m* k_n L^2 / (L^2 + pi^2)),  L = ln e        k_t = k_n, gamma_t = gamma_n
//   `viscous`: L = ln e_max + St_c / St,  St = m* v_n / (6 pi mu R*^2)
//
// Sources: H. Hertz (1881) for the energy that the two springs share at V; P.A. Cundall, O.D.L.
//   Strack, Geotechnique 29 (1979) 47; `viscous`: M.W. Schmeeckle et al., Phys. Fluids 13 (2001)
//   and D. Legendre et al., Chem. Eng. Sci. 61 (2006).
// Inputs: E* [Pa] as of normal_hertz.h, V [m/s], e; `viscous`: mu [Pa s], St_c, e_max.
// Range: V > 0, 0 < e <= 1; `viscous`: mu > 0, St_c > 0, 0 < e_max <= 1.
// Words: tangential_damping on, limitForce off, viscous off, ktToKnUser off (on: k_t = 2/7 k_n).
// Deviations: none from LIGGGHTS's `model hooke`, which writes 2/7 to nine digits; so does this.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/normal_force.h"
#include "fix_cfd_coupling/dem_physics/contact/property_range.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain::contact {

class NormalHooke {
 public:
  static constexpr const char* name = "hooke";

  struct Pair {
    double modulus = 0.0;                    // E*
    double log_restitution = 0.0;            // of e, or of e_max
    double viscosity = 0.0, stokes_c = 0.0;  // of `viscous`
  };

  void words(LawWords& words) {
    words.on_off("viscous", viscous_, false);
    words.on_off("tangential_damping", tangential_damping_, true);
    words.on_off("limitForce", never_pulls_, false);
    words.on_off("ktToKnUser", softer_shear_, false);
  }
  void connect(ContactHost& host) {
    const auto youngs = per_type_in(host, properties::youngs_modulus);
    const auto poisson = per_type_in(host, properties::poissons_ratio);
    const auto e =
        pairs_in(host, viscous_ ? properties::greatest_restitution : properties::restitution);
    speed_ = scalar_in(host, properties::speed);
    last_radius_ = -1.0;  // what was found before goes by other properties
    pairs_ = table_of(host.types(), [&](int i, int j) {
      return Pair{effective_modulus(youngs[i], poisson[i], youngs[j], poisson[j]),
                  std::log(e(i, j)), 0.0, 0.0};
    });
    if (!viscous_) return;
    const auto viscosity = pairs_in(host, properties::viscosity);
    const auto stokes = pairs_in(host, properties::critical_stokes);
    for (int i = 1; i <= host.types(); ++i)
      for (int j = 1; j <= host.types(); ++j) {
        pairs_(i, j).viscosity = viscosity(i, j);
        pairs_(i, j).stokes_c = stokes(i, j);
      }
  }

  // k_n: the power is most of this law's cost, and contact after contact is of equal spheres.
  [[gnu::always_inline]] inline double prepare(double reduced_radius, double reduced_mass,
                                               std::size_t types) {
    if (reduced_radius != last_radius_ || reduced_mass != last_mass_ || types != last_types_) {
      last_radius_ = reduced_radius;
      last_mass_ = reduced_mass;
      last_types_ = types;
      find_stiffness();
    }
    return last_stiffness_;
  }
  template <class Real>
  [[gnu::always_inline]] inline void touching(TouchOf<Real>& touch) const {
    using std::sqrt;
    const Pair& pair = pairs_[touch.types];
    touch.normal_stiffness = touch.prepared;
    touch.tangential_stiffness = touch.normal_stiffness * (softer_shear_ ? 0.285714286 : 1.0);
    Real log_e = pair.log_restitution;
    if (viscous_) {
      const Real stokes = touch.reduced_mass * touch.parting /
                          (6.0 * pi * pair.viscosity * touch.reduced_radius * touch.reduced_radius);
      log_e = log_e + pair.stokes_c / stokes;
    }
    // Written so that it stays finite where L is 0 (e = 1) or infinite (v_n = 0 of `viscous`).
    const Real ratio = pi / log_e;
    touch.normal_damping =
        sqrt(4.0 * touch.reduced_mass * touch.normal_stiffness / (1.0 + ratio * ratio));
    touch.tangential_damping = tangential_damping_ ? touch.normal_damping : Real(0.0);
    set_normal_force(touch, never_pulls_);
  }

 private:
  void find_stiffness();
  bool tangential_damping_ = true;
  bool never_pulls_ = false;
  bool viscous_ = false;
  bool softer_shear_ = false;
  double speed_ = 0.0;  // V
  PairTable<Pair> pairs_;
  double last_radius_ = -1.0, last_mass_ = -1.0, last_stiffness_ = 0.0;
  std::size_t last_types_ = 0;
};

}  // namespace gasgrain::contact
