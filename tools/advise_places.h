// The scales of a scene before it has run, at the places that matter: in the bed, and in its jet.
//
//   bed   the gas slips as the bed needs it: at minimum fluidisation (total force = weight less
//         buoyancy at eps = 0.42), or as slow as the gas comes; without an inflow a grain alone
//         settles, eps = 1. What the gas does varies over l = half of the box's narrowest width.
//   jet   half-way up the bed (or where it ends to be a core, at 5.8 D): a round turbulent jet of
//   the
//         nozzle's speed U and width D has u = 5.8 U D / x and the half width l = 0.094 x, eps =
//         0.95. Source: S.B. Pope, Turbulent Flows (2000), 5.1.
//   At both: w = u / l, Du/Dt = u^2 / l (along the jet u^2 / x), div tau = mu u / l^2.
//   The fastest grain: the greatest of a fall from where grains are put in, of one thrown as high
//   as the bed is deep, (2 g H)^(1/2), and of one that the nozzle blows over a free path d / (6
//   phi), phi = 0.05. They are estimates of orders of magnitude; the audit of a run has the true
//   ones.
#pragma once

#include <string>
#include <vector>

#include "coupling/exchange/effect_sizes/scales.h"
#include "tools/advise_scene.h"

namespace gasgrain {

struct Place {
  std::string name;
  Scales scales;
};

struct Places {
  std::vector<Place> list;            // the bed, and the jet if there is one
  double superficial = 0.0;           // gas velocity over the empty section [m/s]
  double minimum_fluidisation = 0.0;  // superficial [m/s]
  double nozzle_speed = 0.0;          // of the fastest patch; 0: none [m/s]
  double nozzle_width = 0.0;          // diameter of a circle of its area [m]
  double bed_height = 0.0;            // at rest [m]; 0: not known
  double bed_speed = 0.0;             // of grains in a moving bed [m/s]
  double fastest = 0.0;               // grain to be expected [m/s]
  std::string fastest_reason;
};

Places places_of(const AdviseScene& scene);

// Of gas.toml, where the gauge pressure is 0 [kg/m3].
double gas_density(const GasInput& gas);
// The method that the scene has, or would choose at its first coupling.
VoidFractionMethod method_of(const AdviseScene& scene);

}  // namespace gasgrain
