// Bridges between grains and one wall. A grain has at most one to each wall, at the nearest place
// of it: where a wall is made of triangles, the bridge goes with the grain from one to the next.
//
// A wall that holds liquid has it as an even film on its area and gives that below a grain,
// pi r^2 of it; what a broken bridge leaves on it joins the film. A wall that holds none gives
// none and gets none back. What all grains ask of a wall within a step is never more than it has.
//
// The grain is seen by the wall at some places in a step (`see`), then `advance` decides once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fix_cfd_coupling/dem_physics/liquid/grain_bridges.h"

namespace gasgrain::liquid {

// The liquid of a whole wall, the same on all ranks.
struct WallFilm {
  double area = 0.0;    // [m2]; 0: the wall holds no liquid
  double volume = 0.0;  // [m3]
  double scale = 1.0;   // of what it gives: below 1 when more than all of it was asked for

  [[nodiscard]] bool holds() const { return area > 0.0; }
  [[nodiscard]] double given(double radius) const {
    return holds() ? volume * share(radius) * scale : 0.0;
  }
  [[nodiscard]] double share(double radius) const {
    return std::min(1.0, bridge::pi * radius * radius / area);
  }
};

class WallBridges {
 public:
  // Of a grain, moves with it.
  struct Slot {
    StoredBridge bridge;
    double place;  // where on the wall: a number that the host gives it
  };
  static constexpr int slot_size = StoredBridge::size + 1;
  static_assert(sizeof(Slot) == slot_size * sizeof(double));

  explicit WallBridges(std::string id) : id_(std::move(id)) {}

  [[nodiscard]] const std::string& id() const { return id_; }
  WallFilm& film() { return film_; }
  [[nodiscard]] const WallFilm& film() const { return film_; }
  int type = 0;  // of the wall's material, from 0

  void resize(std::size_t grains) {
    slots_.resize(grains);
    seen_.resize(grains);
  }
  Slot& slot(int k) { return slots_[at(k)]; }

  // The wall is at this gap from grain k, at this place. Whether the bridge is here, once in a
  // step. from_bridge: this place and that of the bridge are parts of one even surface, of which
  // the host shows one at a time; the bridge then comes along.
  bool see(int k, double place, double gap, bool from_bridge) {
    Seen& seen = seen_[at(k)];
    if (gap < seen.gap) {
      seen.gap = gap;
      seen.place = place;
    }
    Slot& slot = slots_[at(k)];
    if (!slot.bridge.stands() || seen.gap_of_bridge != nowhere) return false;
    if (slot.place != place && !from_bridge) return false;
    slot.place = place;
    seen.gap_of_bridge = gap;
    return true;
  }

  // One step of grain k, which this rank owns.
  void advance(const LiquidSettings& s, GrainFilms& films, BridgeCounts& counts, int k,
               double radius, int grain_type) {
    Slot& slot = slots_[at(k)];
    const Seen seen = std::exchange(seen_[at(k)], Seen{});
    StoredBridge& b = slot.bridge;
    if (b.stands()) {
      if (seen.gap_of_bridge > b.rupture && seen.gap <= b.rupture) slot.place = seen.place;
      if (std::min(seen.gap_of_bridge, seen.gap) > b.rupture) {
        ++counts.broken;
        if (seen.gap == nowhere) ++counts.lost_sight;
        break_up(s, films, k, radius, grain_type);
        return;
      }
    } else if (seen.gap == nowhere) {
      b.clear();
      return;
    } else if (!form(s, films, counts, k, radius, grain_type, seen)) {
      return;
    }
    films.count_wall_bridge(k, b.volume);
  }

  // The wall is gone: its share goes with it or, of a wall that holds none, back to the grain.
  void break_up(const LiquidSettings& s, GrainFilms& films, int k, double radius, int grain_type) {
    StoredBridge& b = slots_[at(k)].bridge;
    const Division back = divided(s, b, radius, grain_type);
    films.change(k, back.to_i);
    change_ += back.to_j;
    b.clear();
  }

  [[nodiscard]] Division divided(const LiquidSettings& s, const StoredBridge& b, double radius,
                                 int grain_type) const {
    if (!film_.holds()) return {b.volume, 0.0};
    const BrokenBridge broken{
        b.volume,
        {radius, s.contact_angle(grain_type), given_by_i(b)},
        {std::numeric_limits<double>::infinity(), s.contact_angle(type), given_by_j(b)}};
    return std::visit([&](auto rule) { return rule.divide(broken); }, s.division);
  }

  [[nodiscard]] bridge::LiquidBridge bridge_of(const LiquidSettings& s, double radius,
                                               int grain_type, double volume) const {
    return bridge::bridge_on_wall(radius, s.contact_angle(grain_type), s.contact_angle(type),
                                  s.surface_tension, volume);
  }

  // Of this rank in this step: change of the wall's liquid [m3] and the sum of the shares asked of
  // it. With those of all ranks: settle().
  [[nodiscard]] double change() const { return change_; }
  [[nodiscard]] double asked_share() const { return asked_share_; }
  void settle(double change, double asked_share) {
    film_.volume += change;
    film_.scale = asked_share > 1.0 ? (1.0 - 1e-12) / asked_share : 1.0;
    change_ = asked_share_ = 0.0;
  }

 private:
  static constexpr double nowhere = std::numeric_limits<double>::infinity();
  struct Seen {
    double gap = nowhere;
    double place = 0.0;
    double gap_of_bridge = nowhere;
  };
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  bool form(const LiquidSettings& s, GrainFilms& films, BridgeCounts& counts, int k, double radius,
            int grain_type, const Seen& seen) {
    StoredBridge& b = slots_[at(k)].bridge;
    const GrainFilms::Published& grain = films.published(k);
    const double of_wall = film_.holds() ? film_.volume / film_.area : 0.0;
    const double forms_below = formation_gap(s, grain.thickness, of_wall);
    const double share = s.given_share.value_or(shadow_share_of_wall);
    const double give = given(s, grain, share);
    const double given_by_wall = film_.given(radius);
    const double volume = give + given_by_wall;
    const bool was_asked = b.is_asked();
    b.clear();
    if (seen.gap > forms_below || !(volume > 0.0)) return false;
    if (!was_asked) {
      if (grain.open == GrainFilms::open_to_none) return false;
      b.volume = StoredBridge::asked;
      films.ask(k, share, wall_number);
      if (film_.holds()) asked_share_ += film_.share(radius);
      return false;
    }
    const bridge::LiquidBridge shape = bridge_of(s, radius, grain_type, volume);
    const double rupture = rupture_distance(s, shape);
    if (!films.has_place_for(k, wall_number) || seen.gap > rupture) return false;
    b = {volume, (give - given_by_wall) / volume, rupture, 0.0, 0.0, 0.0};
    know_contact(s, shape, b);
    slots_[at(k)].place = seen.place;
    ++counts.formed;
    films.change(k, -give);
    change_ -= given_by_wall;
    return true;
  }

  static constexpr int wall_number = 0;

  std::string id_;
  WallFilm film_;
  std::vector<Slot> slots_;
  std::vector<Seen> seen_;
  double change_ = 0.0;
  double asked_share_ = 0.0;
};

}  // namespace gasgrain::liquid
