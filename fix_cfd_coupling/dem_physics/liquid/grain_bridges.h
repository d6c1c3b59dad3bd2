// A bridge between two grains in one step: whether it forms, stands or breaks, and where its liquid
// goes. Every rank that sees the pair comes to the same result from the published films.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "fix_cfd_coupling/dem_physics/liquid/bridge_force.h"
#include "fix_cfd_coupling/dem_physics/liquid/grain_films.h"
#include "fix_cfd_coupling/dem_physics/liquid/liquid_settings.h"
#include "fix_cfd_coupling/dem_physics/liquid/shadow_share.h"
#include "fix_cfd_coupling/dem_physics/liquid/stored_bridge.h"

namespace gasgrain::liquid {

// Rupture distance of the scene's law [m].
inline double rupture_distance(const LiquidSettings& s, const bridge::LiquidBridge& b) {
  return std::visit([&](auto law) -> double { return decltype(law)::rupture_distance(b); }, s.law);
}

// Gap at which the liquid of two bodies with films this thick meets [m].
inline double formation_gap(const LiquidSettings& s, double thickness_i, double thickness_j) {
  if (s.formation == Formation::touch) return 0.0;
  if (s.formation == Formation::gap) return s.formation_gap;
  return thickness_i + thickness_j;
}

inline double given_share(const LiquidSettings& s, double radius_i, double radius_j) {
  return s.given_share ? *s.given_share : shadow_share(radius_i, radius_j);
}

// Of the film that may leave a grain, the part that a bridge of this share gets [m3].
inline double given(const LiquidSettings& s, const GrainFilms::Published& grain, double share) {
  return std::max(grain.film - s.film_min, 0.0) * share * grain.scale;
}

struct GrainPair {
  int i, j;             // where the films have them
  bool owns_i, owns_j;  // this rank
  double radius_i, radius_j;
  int type_i, type_j;  // from 0
};
// By which the host knows the two.
struct GrainNumbers {
  int i, j;
};

struct BridgeCounts {
  double formed = 0.0;  // halves: a pair of two ranks is seen by both
  double broken = 0.0;
  // Broken below their rupture distance, where the host no longer shows the other grain, the wall:
  double cut_short = 0.0;
  double lost_sight = 0.0;
};

inline bridge::LiquidBridge bridge_between(const LiquidSettings& s, const GrainPair& p,
                                           double volume) {
  return bridge::bridge_of_grains(p.radius_i, p.radius_j, s.angle_between(p.type_i, p.type_j),
                                  s.surface_tension, volume);
}

inline void give_back(const LiquidSettings& s, GrainFilms& films, const GrainPair& p,
                      const GrainNumbers& numbers, const StoredBridge& b) {
  const BrokenBridge broken{b.volume,
                            {p.radius_i, s.contact_angle(p.type_i), given_by_i(b)},
                            {p.radius_j, s.contact_angle(p.type_j), given_by_j(b)}};
  // Asked of the pair in one order, so that both ranks of a pair divide alike to the last digit.
  const bool swap = numbers.j < numbers.i;
  const BrokenBridge ordered = swap ? BrokenBridge{broken.volume, broken.j, broken.i} : broken;
  const Division d = std::visit([&](auto rule) { return rule.divide(ordered); }, s.division);
  if (p.owns_i) films.change(p.i, swap ? d.to_j : d.to_i);
  if (p.owns_j) films.change(p.j, swap ? d.to_i : d.to_j);
}

// One step of a bridge that does not break in it.
inline void stand(GrainFilms& films, const GrainPair& p, const StoredBridge& b) {
  if (p.owns_i) films.count_bridge(p.i, b.volume);
  if (p.owns_j) films.count_bridge(p.j, b.volume);
}

// One step of the pair at this gap [m]. reach: the greatest gap that the host still shows [m];
// next_gap: at most, in the next step.
inline void advance(const LiquidSettings& s, GrainFilms& films, BridgeCounts& counts,
                    const GrainPair& p, const GrainNumbers& numbers, StoredBridge& b, double gap,
                    double next_gap, double reach) {
  const double weight = 0.5 * (static_cast<int>(p.owns_i) + static_cast<int>(p.owns_j));
  const GrainFilms::Published& of_i = films.published(p.i);
  const GrainFilms::Published& of_j = films.published(p.j);
  if (b.stands()) {
    const bool out_of_reach = next_gap > reach;
    if (gap > b.rupture || out_of_reach) {
      counts.broken += weight;
      if (gap <= b.rupture) counts.cut_short += weight;
      give_back(s, films, p, numbers, b);
      b.clear();
      return;
    }
  } else {
    const double share_i = given_share(s, p.radius_i, p.radius_j);
    const double share_j = given_share(s, p.radius_j, p.radius_i);
    const bool near = gap <= formation_gap(s, of_i.thickness, of_j.thickness) && next_gap <= reach;
    const double give_i = given(s, of_i, share_i);
    const double give_j = given(s, of_j, share_j);
    const double volume = give_i + give_j;
    if (!near || !(volume > 0.0)) {
      b.clear();
      return;
    }
    if (!b.is_asked()) {
      if (of_i.open == GrainFilms::open_to_none || of_j.open == GrainFilms::open_to_none) return;
      b.volume = StoredBridge::asked;
      if (p.owns_i) films.ask(p.i, share_i, numbers.j);
      if (p.owns_j) films.ask(p.j, share_j, numbers.i);
      return;
    }
    if (!films.has_place_for(p.i, numbers.j) || !films.has_place_for(p.j, numbers.i)) {
      b.clear();
      return;
    }
    const bridge::LiquidBridge shape = bridge_between(s, p, volume);
    const double rupture = rupture_distance(s, shape);
    if (gap > rupture) {  // a given formation gap may be longer than this bridge
      b.clear();
      return;
    }
    b.volume = volume;
    b.lean = (give_i - give_j) / volume;
    b.rupture = rupture;
    know_contact(s, shape, b);
    counts.formed += weight;
    if (p.owns_i) films.change(p.i, -give_i);
    if (p.owns_j) films.change(p.j, -give_j);
  }
  stand(films, p, b);
}

}  // namespace gasgrain::liquid
