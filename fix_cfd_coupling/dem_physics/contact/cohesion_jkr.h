// `cohesion jkr`: what JKR's contact adds to Hertz's force (dem_physics/adhesion/jkr.h has the law,
// its units, signs and range). With the normal model `hertz` alone, whose damping stays as it is.
//
// Bodies that have touched hold on to each other by a neck until it snaps; the history knows that
// they did. A neck below zero overlap has the law's pull, no damping and no friction.
// Properties: workOfAdhesion [J/m2], peratomtypepair; or surfaceEnergy [J/m2], peratomtype, of each
//   material, mixed as 2 sqrt(gamma_i gamma_j). The modulus is the host's, of youngsModulus and
//   poissonsRatio. Words: tangential_reduce off.
// With 0 for all pairs nothing is done, and the neighbour lists stay as they were.
#ifdef COHESION_LAW
COHESION_LAW(CohesionJkr, jkr, 23)
#else
#ifndef GASGRAIN_COHESION_JKR_H
#define GASGRAIN_COHESION_JKR_H

#include <algorithm>
#include <vector>

#include "fix_cfd_coupling/dem_physics/adhesion/jkr.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_stamp.h"

namespace gasgrain::contact {

class CohesionJkr : public CentralCohesionLaw {
 public:
  static std::vector<HistoryValue> history(bool /*of_wall*/) { return {{"jkr_touched", false}}; }

  void connect(ContactHost& host) {
    host.refuse_unfit_run();
    if (!host.normal_model_is("hertz"))
      host.refuse(
          "it adds to Hertz's force what JKR's has more, and stands beside 'model hertz' only. "
          "Write "
          "'model hertz', or another cohesion model such as van_der_waals.");
    const double smallest = host.smallest_radius();
    laws_ = laws(host, smallest);
    stamp_.begin_run(host);

    // Of equal surfaces the gap at which the neck snaps goes with R*^(1/3): over the radius it is
    // greatest for the smallest grains.
    const double share = host.is_wall() ? 1.0 : 0.5;
    double of_smallest = 0.0;
    double greatest = 0.0;
    for (int i = 1; i <= laws_.types(); ++i)
      for (int j = 1; j <= laws_.types(); ++j) {
        of_smallest = std::max(of_smallest, snap_gap(laws_(i, j), share * smallest));
        greatest = std::max(greatest, snap_gap(laws_(i, j), share * host.largest_radius()));
      }
    // Beyond the snap the host must still show the bodies once, for the history to forget.
    constexpr double beyond = 1.1;
    acts_ = greatest > 0.0;
    if (acts_) host.reach(beyond * of_smallest, beyond * greatest);
  }

  void touching(ContactView& c, const ContactForces& f) {
    if (!acts_) return;
    if (c.updates && c.history != nullptr) *c.history = stamp_.now(c.step);
    c.keep = true;
    pull_touching(law_of(c).attraction(-c.gap()), c, f);
  }

  void apart(ContactView& c, const ContactForces& f) {
    if (!acts_ || c.history == nullptr) return;
    double& touched = *c.history;
    const double overlap = -c.gap();
    if (!stamp_.holds(touched, c.step) || !law_of(c).touches(overlap, true)) {
      if (c.updates) touched = 0.0;
      c.keep = false;
      return;
    }
    if (c.updates) touched = stamp_.now(c.step);
    c.keep = true;
    pull_apart(law_of(c).attraction(overlap), c, f);
  }

 private:
  using Law = adhesion::Jkr;

  static double snap_gap(Law law, double reduced_radius) {
    law.reduced_radius = reduced_radius;
    return -law.snap_overlap();
  }
  [[nodiscard]] Law law_of(const ContactView& c) const {
    Law law = laws_(c.itype, c.jtype);
    law.reduced_radius = c.reduced_radius();
    return law;
  }

  [[nodiscard]] static PairTable<Law> laws(const ContactHost& host, double radius) {
    const auto youngs = host.need_per_type("youngsModulus", "Pa");
    const auto poisson = host.need_per_type("poissonsRatio", "no unit");
    const auto modulus = [&](int i, int j) {
      return effective_modulus(youngs[i], poisson[i], youngs[j], poisson[j]);
    };
    const auto of_pairs = host.pairs("workOfAdhesion");
    const auto of_types = host.per_type("surfaceEnergy");
    if (of_pairs && of_types)
      host.refuse(
          "there are workOfAdhesion, of pairs, and surfaceEnergy, of materials. Keep one of them.");
    if (of_pairs)
      return checked_laws(host, "workOfAdhesion, youngsModulus, poissonsRatio", [&](int i, int j) {
        return Law{modulus(i, j), 0.5 * radius, (*of_pairs)(i, j)};
      });
    if (!of_types)
      host.refuse_missing(
          "workOfAdhesion",
          fmt::format("fix ID all property/global workOfAdhesion peratomtypepair {} VALUES  (J/m2, "
                      "0.01 to 1)\n  or: surfaceEnergy peratomtype VALUES  (J/m2, each material's)",
                      host.types()));
    return checked_laws(host, "surfaceEnergy, youngsModulus, poissonsRatio", [&](int i, int j) {
      const double gamma_i = (*of_types)[i];
      const double gamma_j = (*of_types)[j];
      // the root of two negative ones would pass
      const double work = std::min(gamma_i, gamma_j) < 0.0
                              ? std::min(gamma_i, gamma_j)
                              : adhesion::work_of_adhesion(gamma_i, gamma_j);
      return Law{modulus(i, j), 0.5 * radius, work};
    });
  }

  bool acts_ = false;  // any work of adhesion is not 0
  ContactStamp stamp_;
  PairTable<Law> laws_;
};

}  // namespace gasgrain::contact
#endif
#endif
