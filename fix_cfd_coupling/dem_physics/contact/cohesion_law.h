// What a cohesion law is: a class that says what it needs, and adds its force to contacts one by
// one. A host's loop holds the law by value and calls it without any virtual function, so that the
// law is inlined into the loop. A law derives from CohesionLaw and hides of it what it has.
//
//   static std::vector<HistoryValue> history(bool of_wall)   what a contact remembers
//   words(LawWords&)      what a script may write after the law's name; before connect()
//   connect(ContactHost&) reads and checks the script's properties. Before every run
//   begin_pass()          before each pass over the pairs; collective. Not called for walls
//   touching(c, f)        bodies in touch, after the normal model, before the tangential one
//   after_all(c, f)       the same contact, after all models have added their forces
//   apart(c, f)           bodies that the host shows up to the gap asked for by reach(); sets
//                         c.acts where it adds a force
//
// The law's file ends with its line for the LIST (cohesion_laws.h).
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_view.h"

namespace gasgrain::contact {

// One double of a contact's history, 0 when the contact is new.
struct HistoryValue {
  const char* name;
  bool changes_sign;  // when the host swaps i and j
};

// Collects a law's words: where the value goes, and what it is when the script does not say.
class LawWords {
 public:
  virtual void number(const char* word, double& value, double otherwise) = 0;
  virtual void on_off(const char* word, bool& value, bool otherwise) = 0;

 protected:
  ~LawWords() = default;
};

class CohesionLaw {
 public:
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return {}; }
  static constexpr bool at_places = false;  // whether the law reads ContactView::place and parts
  void words(LawWords&) {}
  void begin_pass() {}
  void after_all(ContactView&, const ContactForces&) {}
};

// A cohesion law whose force is along the line of centres, with the word tangential_reduce:
// friction's limit is then that of the normal force less the attraction.
class CentralCohesionLaw : public CohesionLaw {
 public:
  void words(LawWords& words) { words.on_off("tangential_reduce", tangential_reduce_, false); }

 protected:
  // Attraction [N] of touching bodies.
  void pull_touching(double attraction, ContactView& c, const ContactForces& f) const {
    if (tangential_reduce_) c.Fn -= attraction;
    pull_along(attraction, c.en, c, f);
  }
  // Attraction [N] of bodies that are apart.
  static void pull_apart(double attraction, ContactView& c, const ContactForces& f) {
    if (attraction == 0.0) return;
    const double scale = 1.0 / std::sqrt(c.rsq);
    const double normal[3] = {scale * c.delta[0], scale * c.delta[1], scale * c.delta[2]};
    pull_along(attraction, normal, c, f);
    c.acts = true;
  }

 private:
  static void pull_along(double attraction, const double* normal, const ContactView& c,
                         const ContactForces& f) {
    const double share = c.is_wall ? c.area_ratio : 1.0;
    for (int d = 0; d < 3; ++d) {
      const double force = attraction * share * normal[d];
      f.force_i[d] -= force;
      if (!c.is_wall) f.force_j[d] += force;
    }
  }

  bool tangential_reduce_ = false;
};

// Where a script names no cohesion.
class CohesionOff : public CohesionLaw {
 public:
  void connect(ContactHost&) {}
  void touching(ContactView&, const ContactForces&) {}
  void apart(ContactView&, const ContactForces&) {}
};

}  // namespace gasgrain::contact
