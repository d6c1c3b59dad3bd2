// What a scene says about its parcels: the words of `fix ID all parcels KEYWORD VALUE...`.
//
//   particles N             particles a parcel of atoms that were not injected (default 1)
//   close_packing T         greatest solid volume fraction (default 0.6: random packing of spheres,
//                           between loose, 0.56, and dense, 0.64)
//   stress PS BETA EPS | off    constant [Pa], exponent and epsilon of the particle stress (default
//                           100 3 1e-7: the values that MFiX-PIC starts from; particle_stress.h)
//   restitution E           of the limiter of the stress, 0 to 1: share of the velocity with which
//   a
//                           parcel came to its surroundings (default 0.4: the value that MFiX 17
//                           starts from)
//   walls SIDE...           sides of the box that are walls: x_lo x_hi y_lo y_hi z_lo z_hi
//                           (default none: all open)
//   retention EN ET         share of the normal and tangential velocity kept at a wall (default 0.3
//                           0.99: table 10.4 of Alobaid 2013)
//   damping on E | off      damping of velocities by collisions, E the restitution of the grains
//                           (default off; velocity_damping.h)
//   isotropy on E S | off   return to isotropy by collisions, at most the share S of the parcels
//                           of a cell redirected in a step (default off; return_to_isotropy.h;
//                           S = 0.4: table 10.4's 40 %)
//   cells NX NY NZ          own grid, where no gas lends its (default: that of the gas)
//   seed N                  of all random numbers (default 1)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/parcels/wall_rebound.h"

namespace gasgrain {

struct ParcelSettings {
  double particles = 1.0;
  double close_packing = 0.6;
  bool stress = true;
  double stress_constant = 100.0;  // [Pa]
  double stress_exponent = 3.0;
  double stress_epsilon = 1e-7;
  double restitution = 0.4;
  Walls walls;
  bool damping = false;
  double damping_restitution = 0.9;
  bool isotropy = false;
  double isotropy_restitution = 0.9;
  double isotropy_share = 0.4;
  std::optional<Int3> cells;
  std::uint64_t seed = 1;
};

// Throws Error with all faults at once.
ParcelSettings parse_parcels(const std::vector<std::string>& words);

}  // namespace gasgrain
