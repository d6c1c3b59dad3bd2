// `cohesion jkr`: what JKR's contact adds to Hertz's force (dem_physics/adhesion/jkr.h has the law,
// its units, signs and range). With the normal model `hertz` alone, whose damping stays as it is.
//
// Bodies that have touched hold on to each other by a neck until it snaps; the history knows that
// they did. A neck below zero overlap has the law's pull, no damping and no friction.
// Properties: workOfAdhesion [J/m2], peratomtypepair; or surfaceEnergy [J/m2], peratomtype, of each
//   material, mixed as 2 sqrt(gamma_i gamma_j). The modulus is the host's, of youngsModulus and
//   poissonsRatio. Words: tangential_reduce off.
// With 0 for all pairs nothing is done, and the neighbour lists stay as they were.
#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_JKR, jkr, 23)
#else
#ifndef GASGRAIN_COHESION_MODEL_JKR_H
#define GASGRAIN_COHESION_MODEL_JKR_H

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/jkr.h"
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion_base.h"
#include "fix_cfd_coupling/liggghts/contact_styles_stamp.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_JKR> : public gasgrain::OwnCohesionModel {
 public:
  CohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : OwnCohesionModel(host, history, model),
        touched_(history->add_history_value("jkr_touched", "0")) {}

  void connectToProperties(PropertyRegistry& registry) override {
    const gasgrain::ContactProperties properties(*lmp, "cohesion jkr");
    properties.refuse_unfit_run();
    if (!normal_model_is("hertz"))
      properties.refuse(
          "it adds to Hertz's force what JKR's has more, and stands beside 'model hertz' only. "
          "Write "
          "'model hertz', or another cohesion model such as van_der_waals.");
    const double smallest = registry.min_radius();
    laws_ = laws(properties, smallest);
    stamp_.begin_run(*lmp);

    // Of equal surfaces the gap at which the neck snaps goes with R*^(1/3): over the radius it is
    // greatest for the smallest grains.
    const double share = is_wall() ? 1.0 : 0.5;
    double of_smallest = 0.0;
    double greatest = 0.0;
    for (int i = 1; i <= laws_.types(); ++i)
      for (int j = 1; j <= laws_.types(); ++j) {
        of_smallest = std::max(of_smallest, snap_gap(laws_(i, j), share * smallest));
        greatest = std::max(greatest, snap_gap(laws_(i, j), share * registry.max_radius()));
      }
    // Beyond the snap the host must still call once, for the history to forget.
    constexpr double beyond = 1.1;
    acts_ = greatest > 0.0;
    if (acts_) reach(beyond * of_smallest, beyond * greatest, registry, properties);
  }

  void surfacesIntersect(Intersect& data, Force& i, Force& j) override {
    if (!acts_) return;
    if (updates(data)) data.contact_history[touched_] = stamp_.now();
    keep_history(data, true);
    pull(law_of(data).attraction(-gap(data)), data, i, j);
  }

  void surfacesClose(Close& data, Force& i, Force& j) override {
    if (!acts_ || data.contact_history == nullptr) return;
    double& touched = data.contact_history[touched_];
    const double overlap = -gap(data);
    if (!stamp_.holds(touched) || !law_of(data).touches(overlap, true)) {
      if (updates(data)) touched = 0.0;
      keep_history(data, false);
      return;
    }
    if (updates(data)) touched = stamp_.now();
    keep_history(data, true);
    pull(law_of(data).attraction(overlap), data, i, j);
  }

 private:
  using Law = gasgrain::adhesion::Jkr;

  static double snap_gap(Law law, double reduced_radius) {
    law.reduced_radius = reduced_radius;
    return -law.snap_overlap();
  }
  [[nodiscard]] Law law_of(const Close& data) const {
    Law law = laws_(data.itype, data.jtype);
    law.reduced_radius = reduced_radius(data);
    return law;
  }

  [[nodiscard]] static gasgrain::PairTable<Law> laws(const gasgrain::ContactProperties& properties,
                                                     double radius) {
    const auto youngs = properties.need_per_type("youngsModulus", "Pa");
    const auto poisson = properties.need_per_type("poissonsRatio", "no unit");
    const auto modulus = [&](int i, int j) {
      return gasgrain::contact::effective_modulus(youngs[i], poisson[i], youngs[j], poisson[j]);
    };
    const auto of_pairs = properties.pairs("workOfAdhesion");
    const auto of_types = properties.per_type("surfaceEnergy");
    if (of_pairs && of_types)
      properties.refuse(
          "there are workOfAdhesion, of pairs, and surfaceEnergy, of materials. Keep one of them.");
    if (of_pairs)
      return checked_laws(properties, "workOfAdhesion, youngsModulus, poissonsRatio",
                          [&](int i, int j) {
                            return Law{modulus(i, j), 0.5 * radius, (*of_pairs)(i, j)};
                          });
    if (!of_types)
      properties.refuse_missing(
          "workOfAdhesion",
          fmt::format("fix ID all property/global workOfAdhesion peratomtypepair {} VALUES  (J/m2, "
                      "0.01 to 1)\n  or: surfaceEnergy peratomtype VALUES  (J/m2, each material's)",
                      properties.types()));
    return checked_laws(
        properties, "surfaceEnergy, youngsModulus, poissonsRatio", [&](int i, int j) {
          const double gamma_i = (*of_types)[i];
          const double gamma_j = (*of_types)[j];
          // the root of two negative ones would pass
          const double work = std::min(gamma_i, gamma_j) < 0.0
                                  ? std::min(gamma_i, gamma_j)
                                  : gasgrain::adhesion::work_of_adhesion(gamma_i, gamma_j);
          return Law{modulus(i, j), 0.5 * radius, work};
        });
  }

  int touched_;
  bool acts_ = false;  // any work of adhesion is not 0
  gasgrain::ContactStamp stamp_;
  gasgrain::PairTable<Law> laws_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
