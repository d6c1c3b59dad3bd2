// `cohesion constant_pull`: a pull that does not change with the gap, as of a short elastic thread
// between any two bodies.
//
//   F = pullForce of the two types [N], from the touch up to greatest_gap; beyond it 0
//
// An example (docs/adding-a-law.md), of no material. Attraction along the line of centres.
// Property: pullForce [N], peratomtypepair, 0 or above.
// Words: greatest_gap [m] 1e-6, tangential_reduce off.
#ifdef COHESION_LAW
COHESION_LAW(CohesionConstantPull, constant_pull, 40)
#else
#ifndef COHESION_CONSTANT_PULL_H
#define COHESION_CONSTANT_PULL_H

#include "fix_cfd_coupling/dem_physics/adhesion/input_faults.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"

namespace gasgrain::contact {

struct ConstantPull {
  double force = 0.0;         // [N]
  double greatest_gap = 0.0;  // [m]

  double at(double gap) const { return gap > greatest_gap ? 0.0 : force; }
};

inline void check(const ConstantPull& law) {
  InputFaults("A constant pull")
      .not_negative("pullForce", law.force, "N", "give 0 to switch it off")
      .positive("greatest_gap", law.greatest_gap, "m", "1e-6 is common")
      .refuse();
}

class CohesionConstantPull : public CentralCohesionLaw {
 public:
  void words(LawWords& words) {
    CentralCohesionLaw::words(words);
    words.number("greatest_gap", greatest_gap_, 1e-6);
  }

  void connect(ContactHost& host) {
    host.refuse_unfit_run();
    const auto force = host.need_pairs("pullForce", "N");
    laws_ = checked_laws(host, "pullForce, greatest_gap", [&](int i, int j) {
      return ConstantPull{force(i, j), greatest_gap_};
    });
    host.reach(greatest_gap_);
  }

  void touching(ContactView& c, const ContactForces& f) {
    pull_touching(laws_(c.itype, c.jtype).at(c.gap()), c, f);
  }
  void apart(ContactView& c, const ContactForces& f) {
    pull_apart(laws_(c.itype, c.jtype).at(c.gap()), c, f);
  }

 private:
  double greatest_gap_ = 0.0;
  PairTable<ConstantPull> laws_;
};

}  // namespace gasgrain::contact
#endif
#endif
