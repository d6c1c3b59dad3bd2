// What a scene says about its liquid: the words after `liquid`, KEYWORD VALUE pairs.
//
//   content X | film V      liquid on each grain at first: share of its volume, or [m3]; 0: dry
//   surface_tension G       [N/m]
//   contact_angle A...      [rad], one for all grain types or one a type
//   law NAME                of bridges.h (default willett: the cheapest that is within 10 % of
//                           Young and Laplace's equation up to v = 1e-3, 20 degrees)
//   division NAME           of divisions.h (default even)
//   viscosity MU  minimum_separation S    [Pa s] [m], both or neither (default: no viscous force)
//   formation films | touch | D    a bridge forms when the films touch (default), the grains, or
//                           at the gap D [m]
//   gives shadow | F        share of its film that a grain gives (default shadow: shadow_share.h)
//   film_min V              liquid that stays on a grain [m3] (default 0)
//   bridges_max N           of a grain (default 0: no limit)
//   wall ID A [FILM]        the wall of this ID holds liquid on its area A [m2] (`mesh`: that of
//   its
//                           triangles), FILM of it at first [m3]; a wall not named holds none
//   packing EPS             void fraction of the voids that the saturation is of (default 0.4)
//   reach F                 greatest gap of a bridge, F (r_i + r_j) (default: from the liquid)
//   every N                 steps between two lines of the ledger (default 1000)
//   output FILE             the ledger (default: none)
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fix_cfd_coupling/dem_physics/bridge/bridges.h"
#include "fix_cfd_coupling/dem_physics/liquid/divisions.h"

namespace gasgrain::liquid {

enum class Formation { films, touch, gap };

struct WallSetting {
  std::string id;
  std::optional<double> area;  // [m2]; empty: of its mesh
  double film = 0.0;           // [m3]
};

struct LiquidSettings {
  std::optional<double> content;
  std::optional<double> film;  // [m3]
  double surface_tension = -1.0;
  std::vector<double> contact_angles;  // by type, from 0
  int types = 0;
  std::vector<bridge::ContactAngle> angles_between;  // of two types
  bridge::BridgeLaw law = bridge::BridgeWillett{};
  DivisionRule division = DivisionEven{};
  double viscosity = 0.0;
  double minimum_separation = 0.0;
  Formation formation = Formation::films;
  double formation_gap = 0.0;
  std::optional<double> given_share;  // empty: the shadow's
  double film_min = 0.0;
  int bridges_max = 0;
  std::vector<WallSetting> walls;
  double packing_void_fraction = 0.4;
  std::optional<double> reach;
  int every = 1000;
  std::string output;

  [[nodiscard]] bool viscous() const { return viscosity > 0.0; }
  [[nodiscard]] double contact_angle(int type) const {
    return contact_angles.size() == 1 ? contact_angles[0]
                                      : contact_angles[static_cast<std::size_t>(type)];
  }
  [[nodiscard]] const bridge::ContactAngle& angle_between(int type_i, int type_j) const {
    return angles_between[static_cast<std::size_t>(type_i * types + type_j)];
  }
  // Liquid of a grain before it met any other [m3].
  [[nodiscard]] double film_at_first(double radius) const;
};

// Throws Error with all faults at once. types: of grains in the scene.
LiquidSettings parse_liquid(const std::vector<std::string>& words, int types);

}  // namespace gasgrain::liquid
