// What a law of friction is: words(), connect(), and touching(touch, stored), the force on i [N]
// along the surfaces; `stored` are its values of the contact's history. It reads what the normal
// law wrote.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/contact/property_range.h"
#include "fix_cfd_coupling/dem_physics/contact/touch.h"

namespace gasgrain::contact {

// With Coulomb's limit, mu |F_n|.
class TangentialLaw {
 public:
  static std::vector<HistoryValue> history() { return {}; }
  static constexpr int remembers = 0;  // how many values its history has
  // Lever arms and walls as LAMMPS's own granular styles have them (touch.h).
  static constexpr bool levers_are_radii = false;

  void words(LawWords&) {}
  void connect(ContactHost& host) { friction_ = pairs_in(host, properties::friction); }

  [[nodiscard]] int types() const { return friction_.types(); }
  // The place of a pair of types in this scene's tables.
  [[nodiscard]] std::size_t place(int type_i, int type_j) const {
    return friction_.at(type_i, type_j);
  }

 protected:
  template <class Real>
  [[nodiscard]] [[gnu::always_inline]] inline Real limit(const TouchOf<Real>& touch) const {
    using std::abs;
    return friction_[touch.types] * abs(touch.normal_force);
  }

 private:
  PairTable<double> friction_;  // mu
};

}  // namespace gasgrain::contact
