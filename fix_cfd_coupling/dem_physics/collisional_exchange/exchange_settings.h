// What a scene says about the collisional exchange: the words after the fix's style, KEYWORD VALUE
// pairs.
//
//   close_packing F         theta_cp,s of (17), solid volume fraction at which tau is 0 (default
//                           0.58, of the paper's channel)
//   k_solid K  k_liquid K   K^S and K^L of (61): collisions it takes a share 1/e, 1/K (defaults
//                           0.01 and 0.1, the paper's for both of its scenes)
//   time_scale_ratio R      of (36): time scale of films over that of velocities, 1 or more
//                           (default 4, the paper's)
//   agglomeration mean | variance   what the widths of the distributions keep in a step,
//                           relaxation.h (default mean: as printed, (53)-(57))
//   species NAME density RHO [heat C0 [C1 ...] range TLO THI]
//                           a liquid [kg/m3] and its specific heat C0 + C1 T + ... [J/(kg K)] over
//                           a range [K]; as many as there are, in the order of the films' columns
//                           (default: none, dry)
//   film_temperature T0     films have temperatures, T0 at first [K]; every species then needs
//                           its heat (default: no temperatures)
//   momentum on | off       off: velocities are left to the contacts of a DEM run, which carry
//                           momentum already (default on)
//   cells NX NY NZ          a grid of the exchange's own over the box (default: the gas's)
//   every N                 steps between two exchanges, each over N steps of time (default 1)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/relaxation.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/species_enthalpy.h"

namespace gasgrain {

struct LiquidSpecies {
  std::string name;
  double density = 0.0;      // [kg/m3]
  SpeciesEnthalpy enthalpy;  // no coefficients: none was given
};

struct ExchangeSettings {
  double close_packing = 0.58;
  double k_solid = 0.01;
  double k_liquid = 0.1;
  double time_scale_ratio = 4.0;
  Agglomeration agglomeration = Agglomeration::mean;
  std::vector<LiquidSpecies> species;
  std::optional<double> film_temperature;  // [K]
  bool momentum = true;
  std::optional<Int3> cells;  // empty: the gas's
  int every = 1;
};

// Throws Error with all faults at once.
ExchangeSettings parse_exchange(const std::vector<std::string>& words);

}  // namespace gasgrain
