// The script's walls that grains touch.
#pragma once

#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include "lammps.h"
// --
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "neighbor.h"
#include "tri_mesh.h"

namespace gasgrain {

struct WallFacts {
  int type = 0;                     // of its material, from 1
  std::optional<double> mesh_area;  // [m2], of all its meshes; nothing: a primitive wall
  double shown_within = 0.0;  // [m], the gap at which the host shows it to a grain for certain
};

// The fix must be a wall of grains.
inline WallFacts wall_facts(LAMMPS_NS::LAMMPS& host, const char* id) {
  auto& modify = *host.modify;
  auto& wall = dynamic_cast<LAMMPS_NS::FixWallGran&>(*modify.fix[modify.find_fix(id)]);
  // A primitive wall within the skin as it was when the lists were made; meshes by the contact
  // distance that is registered.
  if (!wall.is_mesh_wall() || wall.n_meshes() == 0)
    return {wall.atom_type_wall(), std::nullopt, 0.5 * host.neighbor->skin};
  WallFacts facts{wall.mesh_list()[0]->atomTypeWall(), 0.0,
                  std::numeric_limits<double>::infinity()};
  for (int n = 0; n < wall.n_meshes(); ++n)
    *facts.mesh_area += wall.mesh_list()[n]->triMesh()->areaMeshGlobal();
  return facts;
}

// Of the materials of all walls.
inline std::set<int> wall_types(LAMMPS_NS::LAMMPS& host) {
  std::set<int> types;
  for (int n = 0; n < host.modify->nfix; ++n) {
    if (std::strcmp(host.modify->fix[n]->style, "wall/gran") != 0) continue;
    const auto& wall = *static_cast<LAMMPS_NS::FixWallGran*>(host.modify->fix[n]);
    if (!wall.is_mesh_wall()) types.insert(wall.atom_type_wall());
    for (int m = 0; wall.is_mesh_wall() && m < wall.n_meshes(); ++m)
      types.insert(wall.mesh_list()[m]->atomTypeWall());
  }
  return types;
}

// Walls of meshes show what is nearer than this, over the grain's radius; and so do the lists of
// contacts, as the host has one distance for both.
inline void show_wall_within(LAMMPS_NS::LAMMPS& host, const std::string& /*id*/, double factor) {
  host.neighbor->register_contact_dist_factor(factor);
}

}  // namespace gasgrain
