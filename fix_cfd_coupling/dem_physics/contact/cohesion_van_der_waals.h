// `cohesion van_der_waals`: Hamaker's force between grains, and between a grain and a wall
// (dem_physics/adhesion/van_der_waals.h has the law, its units, signs and range).
//
// Properties: hamakerConstant [J], peratomtypepair; or peratomtype, each material's own, mixed as
//   sqrt(A_ii A_jj), across the medium of hamakerMedium (scalar, default 0: gas).
// Words: smallest_gap [m] 4e-10, greatest_gap [m] 1e-6, tangential_reduce off.
// With a constant of 0 for all pairs nothing is done, and the neighbour lists stay as they were.
#ifdef COHESION_LAW
COHESION_LAW(CohesionVanDerWaals, van_der_waals, 21)
#else
#ifndef GASGRAIN_COHESION_VAN_DER_WAALS_H
#define GASGRAIN_COHESION_VAN_DER_WAALS_H

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/hamaker_constant.h"
#include "fix_cfd_coupling/dem_physics/adhesion/van_der_waals.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"

namespace gasgrain::contact {

class CohesionVanDerWaals : public CentralCohesionLaw {
 public:
  void words(LawWords& words) {
    CentralCohesionLaw::words(words);
    words.number("smallest_gap", smallest_gap_, 4e-10);
    words.number("greatest_gap", greatest_gap_, 1e-6);
  }

  void connect(ContactHost& host) {
    host.refuse_unfit_run();
    laws_ = laws(host);
    acts_ = false;
    for (int i = 1; i <= laws_.types(); ++i)
      for (int j = 1; j <= laws_.types(); ++j) acts_ = acts_ || laws_(i, j).hamaker != 0.0;
    if (acts_) host.reach(greatest_gap_);
  }

  void touching(ContactView& c, const ContactForces& f) {
    if (acts_) pull_touching(attraction(c), c, f);
  }
  void apart(ContactView& c, const ContactForces& f) {
    if (acts_) pull_apart(attraction(c), c, f);
  }

 private:
  using Law = adhesion::VanDerWaals;

  [[nodiscard]] double attraction(const ContactView& c) const {
    const Law& law = laws_(c.itype, c.jtype);
    if (c.is_wall) return law.to_wall(c.radi, c.gap());
    // the same order on both ranks of a pair
    const auto [small, large] = std::minmax(c.radi, c.radj);
    return law.between_spheres(small, large, c.gap());
  }

  [[nodiscard]] PairTable<Law> laws(const ContactHost& host) const {
    const auto law = [this](double hamaker) { return Law{hamaker, smallest_gap_, greatest_gap_}; };
    const auto of_pairs = host.pairs("hamakerConstant");
    const auto of_types = host.per_type("hamakerConstant");
    if (of_pairs && of_types)
      host.refuse(
          "hamakerConstant is there twice, as peratomtypepair and as peratomtype. Keep one: of "
          "pairs as it is, or of materials, which are mixed.");
    const auto medium = host.scalar("hamakerMedium");
    if (of_pairs) {
      if (medium)
        host.refuse(
            "hamakerMedium mixes constants of materials, but hamakerConstant is one of pairs. Take "
            "hamakerMedium away, or give hamakerConstant peratomtype.");
      return checked_laws(host, "hamakerConstant, smallest_gap, greatest_gap",
                          [&](int i, int j) { return law((*of_pairs)(i, j)); });
    }
    if (!of_types)
      host.refuse_missing(
          "hamakerConstant",
          fmt::format("fix ID all property/global hamakerConstant peratomtype VALUES  (J, each "
                      "material's own, 1e-20 to 5e-19)\n  or: peratomtypepair {} VALUES  (J, each "
                      "pair's)",
                      host.types()));
    const double a_medium = medium.value_or(0.0);
    return checked_laws(host, "hamakerConstant, hamakerMedium, smallest_gap, greatest_gap",
                        [&](int i, int j) {
                          const double a_i = (*of_types)[i];
                          const double a_j = (*of_types)[j];
                          adhesion::check_hamaker(a_i, a_j, a_medium);
                          return law(adhesion::hamaker_across(a_i, a_j, a_medium));
                        });
  }

  bool acts_ = false;  // any constant is not 0
  double smallest_gap_ = 0.0;
  double greatest_gap_ = 0.0;
  PairTable<Law> laws_;
};

}  // namespace gasgrain::contact
#endif
#endif
