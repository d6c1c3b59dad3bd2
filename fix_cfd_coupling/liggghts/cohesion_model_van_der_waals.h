// `cohesion van_der_waals`: Hamaker's force between grains, and between a grain and a wall
// (dem_physics/adhesion/van_der_waals.h has the law, its units, signs and range).
//
// Properties: hamakerConstant [J], peratomtypepair; or peratomtype, each material's own, mixed as
//   sqrt(A_ii A_jj), across the medium of hamakerMedium (scalar, default 0: gas).
// Words: smallest_gap [m] 4e-10, greatest_gap [m] 1e-6, tangential_reduce off.
// With a constant of 0 for all pairs nothing is done, and the neighbour lists stay as they were.
#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_VAN_DER_WAALS, van_der_waals, 21)
#else
#ifndef GASGRAIN_COHESION_MODEL_VAN_DER_WAALS_H
#define GASGRAIN_COHESION_MODEL_VAN_DER_WAALS_H

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/hamaker_constant.h"
#include "fix_cfd_coupling/dem_physics/adhesion/van_der_waals.h"
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion_base.h"
#include "fix_cfd_coupling/liggghts/contact_styles_properties.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_VAN_DER_WAALS> : public gasgrain::OwnCohesionModel {
 public:
  CohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : OwnCohesionModel(host, history, model) {}

  void registerSettings(Settings& settings) override {
    OwnCohesionModel::registerSettings(settings);
    settings.registerDoubleSetting("smallest_gap", smallest_gap_, 4e-10);
    settings.registerDoubleSetting("greatest_gap", greatest_gap_, 1e-6);
  }

  void connectToProperties(PropertyRegistry& registry) override {
    const gasgrain::ContactProperties properties(*lmp, "cohesion van_der_waals");
    properties.refuse_unfit_run();
    laws_ = laws(properties);
    acts_ = false;
    for (int i = 1; i <= laws_.types(); ++i)
      for (int j = 1; j <= laws_.types(); ++j) acts_ = acts_ || laws_(i, j).hamaker != 0.0;
    if (acts_) reach(greatest_gap_, registry, properties);
  }

  void surfacesIntersect(Intersect& data, Force& i, Force& j) override {
    if (acts_) pull(attraction(data), data, i, j);
  }
  void surfacesClose(Close& data, Force& i, Force& j) override {
    if (acts_) pull(attraction(data), data, i, j);
  }

 private:
  using Law = gasgrain::adhesion::VanDerWaals;

  [[nodiscard]] double attraction(const Close& data) const {
    const Law& law = laws_(data.itype, data.jtype);
    if (data.is_wall) return law.to_wall(data.radi, gap(data));
    // the same order on both ranks of a pair
    const auto [small, large] = std::minmax(data.radi, data.radj);
    return law.between_spheres(small, large, gap(data));
  }

  [[nodiscard]] gasgrain::PairTable<Law> laws(const gasgrain::ContactProperties& properties) const {
    const auto law = [this](double hamaker) { return Law{hamaker, smallest_gap_, greatest_gap_}; };
    const auto of_pairs = properties.pairs("hamakerConstant");
    const auto of_types = properties.per_type("hamakerConstant");
    if (of_pairs && of_types)
      properties.refuse(
          "hamakerConstant is there twice, as peratomtypepair and as peratomtype. Keep one: of "
          "pairs as it is, or of materials, which are mixed.");
    const auto medium = properties.scalar("hamakerMedium");
    if (of_pairs) {
      if (medium)
        properties.refuse(
            "hamakerMedium mixes constants of materials, but hamakerConstant is one of pairs. Take "
            "hamakerMedium away, or give hamakerConstant peratomtype.");
      return checked_laws(properties, "hamakerConstant, smallest_gap, greatest_gap",
                          [&](int i, int j) { return law((*of_pairs)(i, j)); });
    }
    if (!of_types)
      properties.refuse_missing(
          "hamakerConstant",
          fmt::format("fix ID all property/global hamakerConstant peratomtype VALUES  (J, each "
                      "material's own, 1e-20 to 5e-19)\n  or: peratomtypepair {} VALUES  (J, each "
                      "pair's)",
                      properties.types()));
    const double a_medium = medium.value_or(0.0);
    return checked_laws(properties, "hamakerConstant, hamakerMedium, smallest_gap, greatest_gap",
                        [&](int i, int j) {
                          const double a_i = (*of_types)[i];
                          const double a_j = (*of_types)[j];
                          gasgrain::adhesion::check_hamaker(a_i, a_j, a_medium);
                          return law(gasgrain::adhesion::hamaker_across(a_i, a_j, a_medium));
                        });
  }

  bool acts_ = false;  // any constant is not 0
  double smallest_gap_ = 0.0;
  double greatest_gap_ = 0.0;
  gasgrain::PairTable<Law> laws_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
