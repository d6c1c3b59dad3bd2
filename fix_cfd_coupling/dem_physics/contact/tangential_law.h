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
  static constexpr bool remembers = false;  // whether it has a history
  // Lever arms and walls as LAMMPS's own granular styles have them (touch.h).
  static constexpr bool levers_are_radii = false;

  void words(LawWords&) {}
  void connect(ContactHost& host) { friction_ = pairs_in(host, properties::friction); }

  // The place of a pair of types in this scene's tables.
  [[nodiscard]] std::size_t place(int type_i, int type_j) const {
    return friction_.at(type_i, type_j);
  }

 protected:
  [[nodiscard]] double limit(const Touch& touch) const {
    return friction_[touch.types] * std::abs(touch.normal_force);
  }

 private:
  PairTable<double> friction_;  // mu
};

}  // namespace gasgrain::contact
