// `cohesion bridge`: liquid bridges between grains, and between a grain and a wall, that keep their
// liquid. The liquid is that of `fix liquid` (liquid/scene_liquid.h), the laws are in
// dem_physics/bridge and dem_physics/liquid; properties and words: none.
//
// A bridge of two grains is kept in the contact's history, one to a wall by the scene's liquid.
// Friction's limit needs no correction: what a bridge pulls, the contact pushes back, and that is
// what the tangential model sees.
#ifdef COHESION_LAW
COHESION_LAW(CohesionBridge, bridge, 20)
#else
#ifndef GASGRAIN_COHESION_BRIDGE_H
#define GASGRAIN_COHESION_BRIDGE_H

#include <cmath>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/liquid/bridge_force.h"
#include "fix_cfd_coupling/dem_physics/liquid/grain_bridges.h"
#include "fix_cfd_coupling/dem_physics/liquid/scene_liquid.h"

namespace gasgrain::contact {

class CohesionBridge : public CohesionLaw {
 public:
  static constexpr bool at_places = true;

  // Those of liquid::StoredBridge, in its order.
  static std::vector<HistoryValue> history(bool of_wall) {
    if (of_wall) return {};
    return {{"bridge_volume", false},         {"bridge_lean", true},
            {"bridge_rupture", false},        {"bridge_pull", false},
            {"bridge_damping_normal", false}, {"bridge_damping_tangential", false}};
  }

  void connect(ContactHost& host) {
    host.refuse_coarse_grains();
    liquid_ = &host.liquid();
    numbers_ = host.numbers();
    if (host.is_wall())
      wall_ = &liquid_->join_wall(host.wall_id());
    else
      reach_ = liquid_->join_pairs(host.history_offset());
  }

  void touching(ContactView& c, const ContactForces& f) { act(c, f); }
  void apart(ContactView& c, const ContactForces& f) { act(c, f); }

 private:
  void act(ContactView& c, const ContactForces& f) {
    if (!liquid_->wet()) return;
    if (c.is_wall)
      act_on_wall(c, f);
    else
      act_on_pair(c, f);
  }

  void act_on_pair(ContactView& c, const ContactForces& f) {
    liquid::StoredBridge& bridge = liquid::stored_bridge(c.history);
    const auto& settings = liquid_->settings();
    auto& films = liquid_->films();
    if (bridge.absent()) {
      if (!c.updates) return;
      const double forms = c.radsum * (1.0 + round_off) +
                           liquid::formation_gap(settings, films.published(c.i).thickness,
                                                 films.published(c.j).thickness);
      if (c.rsq > forms * forms) return;
    }
    const double distance = std::sqrt(c.rsq);
    const double gap = distance - c.radsum;
    const Vec3 normal = vec(c.delta) * (1.0 / distance);
    const Vec3 velocity = vec(c.v_i) - vec(c.v_j);
    const liquid::GrainPair pair{c.i,    c.j,    true,        c.owns_j,
                                 c.radi, c.radj, c.itype - 1, c.jtype - 1};
    if (c.updates) {
      const double next_gap = gap + 2.0 * std::abs(velocity.dot(normal)) * c.dt;
      const double margin = round_off * c.radsum;
      if (bridge.stands() && gap < bridge.rupture - margin && next_gap < reach_ * c.radsum - margin)
        liquid::stand(films, pair, bridge);
      else
        decide(pair, c.delta, c.dt, bridge, velocity);
      c.keep = !bridge.absent();
    }
    if (!bridge.stands()) return;
    const Vec3 pull = -(gap > 0.0 ? pull_over(pair, bridge, gap) : bridge.pull) * normal;
    add(pull, f.force_i);
    add(-pull, f.force_j);
    c.acts = true;
    if (settings.viscous()) drag_pair(c, pair, bridge, gap, normal, velocity, f);
  }

  // What follows is kept out of the loop, which most bridges of a bed pass in overlap.
  [[gnu::noinline]] double pull_over(const liquid::GrainPair& pair,
                                     const liquid::StoredBridge& bridge, double gap) const {
    const auto& settings = liquid_->settings();
    const auto shape = [&] { return liquid::bridge_between(settings, pair, bridge.volume); };
    return liquid::pull_of(settings, bridge, shape, gap);
  }

  void drag_pair(const ContactView& c, const liquid::GrainPair& pair,
                 const liquid::StoredBridge& bridge, double gap, const Vec3& normal,
                 const Vec3& velocity, const ContactForces& f) {
    const auto& films = liquid_->films();
    const double share = gap / c.radsum;
    const liquid::BridgeMotion motion{
        gap,
        normal,
        velocity,
        vec(c.omega_i),
        vec(c.omega_j),
        c.radi * (1.0 + share),
        c.radj * (1.0 + share),
        c.dt * (films.published(c.i).bridges_over_mass + films.published(c.j).bridges_over_mass)};
    const liquid::BridgeForce drag = drag_of(motion, pair, bridge);
    add(drag.on_i, f.force_i);
    add(-drag.on_i, f.force_j);
    add(drag.torque_i, f.torque_i);
    add(drag.torque_j, f.torque_j);
  }
  [[gnu::noinline]] liquid::BridgeForce drag_of(const liquid::BridgeMotion& motion,
                                                const liquid::GrainPair& pair,
                                                const liquid::StoredBridge& bridge) {
    const auto& settings = liquid_->settings();
    const auto shape = [&] { return liquid::bridge_between(settings, pair, bridge.volume); };
    return liquid::viscous_force(settings, bridge, shape, motion, liquid_->held_back());
  }

  // Where a bridge may form or break. Across a periodic face the two owners see distances that
  // differ in their last digits; what they decide must not.
  [[gnu::noinline]] void decide(const liquid::GrainPair& pair, const double* delta, double dt,
                                liquid::StoredBridge& bridge, const Vec3& velocity) {
    const Vec3 apart = liquid_->periodic() ? liquid_->between(pair.i, pair.j) : vec(delta);
    const double distance = apart.norm();
    const double radsum = pair.radius_i + pair.radius_j;
    const double gap = distance - radsum;
    const double next_gap = gap + 2.0 * std::abs(velocity.dot(apart)) / distance * dt;
    const int* numbers = *numbers_;
    liquid::advance(liquid_->settings(), liquid_->films(), liquid_->counts(), pair,
                    {numbers[pair.i], numbers[pair.j]}, bridge, gap, next_gap, reach_ * radsum);
  }

  void act_on_wall(ContactView& c, const ContactForces& f) {
    const int i = c.i;
    const double distance = std::sqrt(c.rsq);
    const double gap = distance - c.radi;
    auto& slot = wall_->slot(i);
    const bool here = c.updates ? wall_->see(i, c.place, gap, goes_on_from(slot.place, c))
                                : slot.bridge.stands() && slot.place == c.place;
    if (!here || gap > slot.bridge.rupture) return;
    const auto& settings = liquid_->settings();
    const auto shape = [&] {
      return wall_->bridge_of(settings, c.radi, c.itype - 1, slot.bridge.volume);
    };
    const Vec3 normal = vec(c.delta) * (1.0 / distance);
    add(-liquid::pull_of(settings, slot.bridge, shape, gap) * normal, f.force_i);
    c.acts = true;
    if (!settings.viscous()) return;
    const liquid::BridgeMotion motion{gap,
                                      normal,
                                      vec(c.v_i) - vec(c.v_j),
                                      vec(c.omega_i),
                                      Vec3::Zero(),
                                      c.radi + gap,
                                      0.0,
                                      c.dt * liquid_->films().published(i).bridges_over_mass};
    const auto drag =
        liquid::viscous_force(settings, slot.bridge, shape, motion, liquid_->held_back());
    add(drag.on_i, f.force_i);
    add(drag.torque_i, f.torque_i);
  }

  static bool goes_on_from(double from, const ContactView& c) {
    return from == c.place || (c.parts != nullptr && c.parts->goes_on(from, c.place));
  }

  // Of the sum of radii: more than distances across a periodic face differ by, and far less than
  // what matters.
  static constexpr double round_off = 1e-9;

  double reach_ = 0.0;  // greatest gap of a bridge of grains, over r_i + r_j
  liquid::SceneLiquid* liquid_ = nullptr;
  liquid::WallBridges* wall_ = nullptr;
  const int* const* numbers_ = nullptr;
};

}  // namespace gasgrain::contact
#endif
#endif
