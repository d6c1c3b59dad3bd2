// What our cohesion models have in common: no work where a model has none, the force along the line
// of centres, and the script's word tangential_reduce (as in the host's sjkr: friction's limit is
// that of the normal force less the attraction).
#pragma once

#include <cmath>

#include "fix_cfd_coupling/dem_physics/contact_time.h"
#include "fix_cfd_coupling/liggghts/contact_styles_ids.h"
#include "fix_cfd_coupling/liggghts/contact_styles_properties.h"
// --
#include "fix_wall_gran.h"
#include "neighbor.h"
#include "pair_gran.h"

namespace gasgrain {

class OwnCohesionModel : public LIGGGHTS::ContactModels::CohesionModelBase {
 protected:
  using Close = LIGGGHTS::ContactModels::SurfacesCloseData;
  using Intersect = LIGGGHTS::ContactModels::SurfacesIntersectData;
  using Force = LIGGGHTS::ContactModels::ForceData;
  using History = LIGGGHTS::IContactHistorySetup;
  using Model = LIGGGHTS::ContactModels::ContactModelBase;

 public:
  OwnCohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : CohesionModelBase(host, history, model), history_(history) {}

  void registerSettings(Settings& settings) override {
    settings.registerOnOff("tangential_reduce", tangential_reduce_, false);
  }
  void postSettings(History*, Model*) override {}
  void endSurfacesIntersect(Intersect&, Force&, Force&) override {}
  void beginPass(Intersect&, Force&, Force&) override {}
  void endPass(Intersect&, Force&, Force&) override {}

 protected:
  // Distance of the surfaces [m], below 0 for an overlap. Of a wall the host gives radsum = radi.
  static double gap(const Close& data) { return std::sqrt(data.rsq) - data.radsum; }

  // Asks the host for surfacesClose() up to this gap [m] of the smallest grains: its factor is of
  // the sum of the radii of two grains, and of one radius at a wall. Of a primitive wall it sees
  // what is within the skin when the neighbour lists are made, from which grains may move by half
  // of it; `greatest_gap` is that of the largest grains.
  void reach(double gap_of_smallest, double greatest_gap, PropertyRegistry& registry,
             const gasgrain::ContactProperties& properties) {
    constexpr double round_off = 1e-9;
    auto* wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(history_);
    const double radius = registry.min_radius();
    neighbor->register_contact_dist_factor(1.0 + (1.0 + round_off) * gap_of_smallest /
                                                     (wall != nullptr ? radius : 2.0 * radius));
    if (wall != nullptr && !wall->is_mesh_wall() && greatest_gap > 0.5 * neighbor->skin)
      properties.refuse(fmt::format(
          "the force reaches over gaps of {:.3g} m, but a primitive wall sees grains within half "
          "of the skin only, {:.3g} m. Write 'neighbor {:.3g} bin', or make the reach shorter.",
          greatest_gap, 0.5 * neighbor->skin, 2.001 * greatest_gap));
  }
  void reach(double gap, PropertyRegistry& registry,
             const gasgrain::ContactProperties& properties) {
    reach(gap, gap, registry, properties);
  }
  // For a model without properties; the others' refuse_unfit_run() says the same.
  void refuse_coarse_grains(const std::string& model) {
    if (force->cg_active()) error->cg(FLERR, model.c_str());
  }
  // Whether the contact's history may change: not while forces are only looked at.
  static bool updates(const Close& data) {
    return data.computeflag != 0 && data.shearupdate != 0 && data.contact_history != nullptr;
  }
  // What the host keeps of a contact between two makings of the neighbour lists.
  static void keep_history(const Close& data, bool keep) {
    if (data.contact_flags == nullptr) return;
    if (keep)
      *data.contact_flags |= LIGGGHTS::ContactModels::CONTACT_COHESION_MODEL;
    else
      *data.contact_flags &= ~LIGGGHTS::ContactModels::CONTACT_COHESION_MODEL;
  }
  [[nodiscard]] bool is_wall() const {
    return dynamic_cast<LAMMPS_NS::FixWallGran*>(history_) != nullptr;
  }
  static double reduced_radius(const Close& data) {
    return data.is_wall ? data.radi : gasgrain::contact::effective(data.radi, data.radj);
  }
  // The normal model's name as the script has it is `name`.
  [[nodiscard]] bool normal_model_is(const char* name) const {
    if (auto* wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(history_))
      return wall->contact_match("normal", name);
    return dynamic_cast<LAMMPS_NS::PairGran&>(*history_).contact_match("normal", name);
  }

  // Attraction [N] of touching bodies.
  void pull(double attraction, Intersect& data, Force& i, Force& j) const {
    if (tangential_reduce_) data.Fn -= attraction;
    pull_along(attraction, data.en, data, i, j);
  }
  // Attraction [N] of bodies that do not touch.
  static void pull(double attraction, Close& data, Force& i, Force& j) {
    if (attraction == 0.0) return;
    const double scale = 1.0 / std::sqrt(data.rsq);
    const double normal[3] = {scale * data.delta[0], scale * data.delta[1], scale * data.delta[2]};
    pull_along(attraction, normal, data, i, j);
    data.has_force_update = true;
  }
  bool tangential_reduce_ = false;
  History* history_;  // the pair style or the wall

 private:
  // The normal points from j, or the wall, to i.
  static void pull_along(double attraction, const double* normal, const Close& data, Force& i,
                         Force& j) {
    const double share = data.is_wall ? data.area_ratio : 1.0;
    for (int d = 0; d < 3; ++d) {
      const double force = attraction * share * normal[d];
      i.delta_F[d] -= force;
      if (!data.is_wall) j.delta_F[d] += force;
    }
  }
};

}  // namespace gasgrain
