// `cohesion bridge`: liquid bridges between grains, and between a grain and a wall, that keep their
// liquid. The liquid is that of `fix liquid` (fix_liquid.h), the laws are in dem_physics/bridge and
// dem_physics/liquid; properties and words: none.
//
// A bridge of two grains is kept in the contact's history, one to a wall by fix liquid. Friction's
// limit needs no correction: what a bridge pulls, the contact pushes back, and that is what the
// tangential model sees.
#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_BRIDGE, bridge, 20)
#else
#ifndef GASGRAIN_COHESION_MODEL_BRIDGE_H
#define GASGRAIN_COHESION_MODEL_BRIDGE_H

#include <cmath>

#include "fix_cfd_coupling/dem_physics/liquid/bridge_force.h"
#include "fix_cfd_coupling/dem_physics/liquid/grain_bridges.h"
#include "fix_cfd_coupling/fixes/fix_liquid.h"
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion_base.h"
// --
#include "atom.h"
#include "fix_mesh_surface.h"
#include "tri_mesh.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_BRIDGE> : public gasgrain::OwnCohesionModel {
  using Vec3 = gasgrain::Vec3;

 public:
  CohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : OwnCohesionModel(host, history, model) {
    if (model->is_wall()) return;
    history_offset_ = history->add_history_value("bridge_volume", "0");
    history->add_history_value("bridge_lean", "1");
    for (const char* of_bridge :
         {"bridge_rupture", "bridge_pull", "bridge_damping_normal", "bridge_damping_tangential"})
      history->add_history_value(of_bridge, "0");
    model->add_history_offset("bridge_volume", history_offset_);
  }

  void registerSettings(Settings&) override {}

  void connectToProperties(PropertyRegistry&) override {
    refuse_coarse_grains("cohesion bridge");
    liquid_ = &LAMMPS_NS::FixLiquid::of_scene(lmp);
    if (auto* wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(history_)) {
      wall_fix_ = wall;
      wall_ = &liquid_->join_wall(wall->id);
    } else {
      reach_ = liquid_->join_pairs(history_offset_);
    }
  }

  void surfacesIntersect(Intersect& data, Force& i, Force& j) override { act(data, i, j); }
  void surfacesClose(Close& data, Force& i, Force& j) override { act(data, i, j); }

 private:
  void act(Close& data, Force& i, Force& j) {
    if (!liquid_->wet()) return;
    if (data.is_wall)
      act_on_wall(data, i);
    else
      act_on_pair(data, i, j);
  }

  void act_on_pair(Close& data, Force& force_i, Force& force_j) {
    namespace liquid = gasgrain::liquid;
    liquid::StoredBridge& bridge = liquid::stored_bridge(data.contact_history + history_offset_);
    const auto& settings = liquid_->settings();
    auto& films = liquid_->films();
    const bool updates = data.computeflag != 0 && data.shearupdate != 0;
    if (bridge.absent()) {
      if (!updates) return;
      const double forms = data.radsum * (1.0 + round_off) +
                           liquid::formation_gap(settings, films.published(data.i).thickness,
                                                 films.published(data.j).thickness);
      if (data.rsq > forms * forms) return;
    }
    const double distance = std::sqrt(data.rsq);
    const double gap = distance - data.radsum;
    const Vec3 normal = vec(data.delta) * (1.0 / distance);
    const Vec3 velocity = vec(data.v_i) - vec(data.v_j);
    const liquid::GrainPair pair{data.i,    data.j,    true,           data.j < atom->nlocal,
                                 data.radi, data.radj, data.itype - 1, data.jtype - 1};
    if (updates) {
      const double next_gap = gap + 2.0 * std::abs(velocity.dot(normal)) * update->dt;
      const double margin = round_off * data.radsum;
      if (bridge.stands() && gap < bridge.rupture - margin &&
          next_gap < reach_ * data.radsum - margin)
        liquid::stand(films, pair, bridge);
      else
        decide(data, pair, bridge, velocity);
      if (data.contact_flags != nullptr) {
        if (bridge.absent())
          *data.contact_flags &= ~CONTACT_COHESION_MODEL;
        else
          *data.contact_flags |= CONTACT_COHESION_MODEL;
      }
    }
    if (!bridge.stands()) return;
    const auto shape = [&] { return liquid::bridge_between(settings, pair, bridge.volume); };
    const Vec3 pull = -liquid::pull_of(settings, bridge, shape, gap) * normal;
    add(pull, force_i.delta_F);
    add(-pull, force_j.delta_F);
    data.has_force_update = true;
    if (!settings.viscous()) return;
    const double share = gap / data.radsum;
    const liquid::BridgeMotion motion{gap,
                                      normal,
                                      velocity,
                                      vec(atom->omega[data.i]),
                                      vec(atom->omega[data.j]),
                                      data.radi * (1.0 + share),
                                      data.radj * (1.0 + share),
                                      update->dt * (films.published(data.i).bridges_over_mass +
                                                    films.published(data.j).bridges_over_mass)};
    const auto drag = liquid::viscous_force(settings, bridge, shape, motion, liquid_->held_back());
    add(drag.on_i, force_i.delta_F);
    add(-drag.on_i, force_j.delta_F);
    add(drag.torque_i, force_i.delta_torque);
    add(drag.torque_j, force_j.delta_torque);
  }

  // Where a bridge may form or break. Across a periodic face the two owners see distances that
  // differ in their last digits; what they decide must not.
  void decide(const Close& data, const gasgrain::liquid::GrainPair& pair,
              gasgrain::liquid::StoredBridge& bridge, const Vec3& velocity) {
    const Vec3 apart = liquid_->periodic() ? liquid_->between(data.i, data.j) : vec(data.delta);
    const double distance = apart.norm();
    const double gap = distance - data.radsum;
    const double next_gap = gap + 2.0 * std::abs(velocity.dot(apart)) / distance * update->dt;
    gasgrain::liquid::advance(liquid_->settings(), liquid_->films(), liquid_->counts(), pair,
                              {atom->tag[data.i], atom->tag[data.j]}, bridge, gap, next_gap,
                              reach_ * data.radsum);
  }

  void act_on_wall(Close& data, Force& force_i) {
    namespace liquid = gasgrain::liquid;
    const int i = data.i;
    const double distance = std::sqrt(data.rsq);
    const double gap = distance - data.radi;
    const double place = place_of(data);
    auto& slot = wall_->slot(i);
    const bool here = data.computeflag != 0 && data.shearupdate != 0
                          ? wall_->see(i, place, gap, goes_on_from(slot.place, place, data))
                          : slot.bridge.stands() && slot.place == place;
    if (!here || gap > slot.bridge.rupture) return;
    const auto& settings = liquid_->settings();
    const auto shape = [&] {
      return wall_->bridge_of(settings, data.radi, data.itype - 1, slot.bridge.volume);
    };
    const Vec3 normal = vec(data.delta) * (1.0 / distance);
    add(-liquid::pull_of(settings, slot.bridge, shape, gap) * normal, force_i.delta_F);
    data.has_force_update = true;
    if (!settings.viscous()) return;
    const liquid::BridgeMotion motion{gap,
                                      normal,
                                      vec(data.v_i) - vec(data.v_j),
                                      vec(atom->omega[i]),
                                      Vec3::Zero(),
                                      data.radi + gap,
                                      0.0,
                                      update->dt * liquid_->films().published(i).bridges_over_mass};
    const auto drag =
        liquid::viscous_force(settings, slot.bridge, shape, motion, liquid_->held_back());
    add(drag.on_i, force_i.delta_F);
    add(drag.torque_i, force_i.delta_torque);
  }

  // Triangles have numbers of their own in each mesh of the wall; a primitive wall is one place.
  [[nodiscard]] double place_of(const Close& data) const {
    if (!wall_fix_->is_mesh_wall()) return 0.0;
    int mesh = 0;
    while (mesh < wall_fix_->n_meshes() && wall_fix_->mesh_list()[mesh] != data.fix_mesh) ++mesh;
    return meshes * (1.0 + data.mesh->id(data.j)) + mesh;
  }
  // Whether two places are neighbouring triangles of one plane.
  [[nodiscard]] static bool goes_on_from(double from, double place, const Close& data) {
    if (from == place || from < meshes || data.mesh == nullptr) return from == place;
    const auto triangle = [](double at) { return static_cast<int>(std::floor(at / meshes)) - 1; };
    return std::fmod(from, meshes) == std::fmod(place, meshes) &&
           data.mesh->map(triangle(from), 0) >= 0 &&
           data.mesh->areCoplanarNodeNeighs(triangle(from), triangle(place));
  }

  static void add(const Vec3& what, double* to) {
    for (int d = 0; d < 3; ++d) to[d] += what[d];
  }
  static Vec3 vec(const double* v) { return {v[0], v[1], v[2]}; }

  // Of the sum of radii: more than distances across a periodic face differ by, and far less than
  // what matters.
  static constexpr double round_off = 1e-9;
  static constexpr double meshes = 1024.0;  // of one wall, at most
  int history_offset_ = -1;
  double reach_ = 0.0;
  LAMMPS_NS::FixLiquid* liquid_ = nullptr;
  LAMMPS_NS::FixWallGran* wall_fix_ = nullptr;
  gasgrain::liquid::WallBridges* wall_ = nullptr;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
