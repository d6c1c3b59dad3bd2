// The script's walls that grains touch: `fix wall/gran/bridge`, of primitive shapes.
#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>

#include "fix_cfd_coupling/lammps/fix_wall_gran_bridge.h"
// --
#include "modify.h"

namespace gasgrain {

struct WallFacts {
  int type = 0;                     // of its material, from 1
  std::optional<double> mesh_area;  // [m2], of all its meshes; nothing: a primitive wall
  double shown_within = 0.0;        // [m], the gap at which it is shown to a grain for certain
};

// The fix must be a wall of grains. It looks as far as show_wall_within() tells it.
inline WallFacts wall_facts(LAMMPS_NS::LAMMPS& host, const char* id) {
  auto& modify = *host.modify;
  const auto& wall = dynamic_cast<LAMMPS_NS::FixWallGranBridge&>(*modify.fix[modify.find_fix(id)]);
  return {wall.type(), std::nullopt, std::numeric_limits<double>::infinity()};
}

// Of the materials of all walls.
inline std::set<int> wall_types(LAMMPS_NS::LAMMPS& host) {
  std::set<int> types;
  for (int n = 0; n < host.modify->nfix; ++n)
    if (auto* wall = dynamic_cast<LAMMPS_NS::FixWallGranBridge*>(host.modify->fix[n]))
      types.insert(wall->type());
  return types;
}

// The wall shows what is nearer to it than this, over the grain's radius.
inline void show_wall_within(LAMMPS_NS::LAMMPS& host, const std::string& id, double factor) {
  auto& modify = *host.modify;
  dynamic_cast<LAMMPS_NS::FixWallGranBridge&>(*modify.fix[modify.find_fix(id)])
      .reach_at_least(factor);
}

}  // namespace gasgrain
