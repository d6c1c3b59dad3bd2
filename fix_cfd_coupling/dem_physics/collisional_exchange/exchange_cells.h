// What the collisional exchange knows of the cells of a tile after a step; the same on all ranks
// that share a cell. Cells without parcels are 0, their collision time is infinite.
#pragma once

#include <vector>

#include "coupling/base/array3.h"

namespace gasgrain {

struct ExchangeCells {
  Array3<double> solid_mass;                  // sum N_p M_s [kg]
  std::vector<Array3<double>> species_mass;   // sum N_p M_f,i [kg], by species
  Array3<double> equilibrium_velocity[3];     // (4), (45) [m/s]
  Array3<double> rms_velocity;                // u'_rms before the step, (14) [m/s]
  Array3<double> collision_time;              // (13) [s]; infinite: no collisions, 0: close packing
  Array3<double> particle_fraction;           // theta_p, solids and films, (15)
  Array3<double> solid_fraction;              // theta_s, (18)
  Array3<double> close_packing;               // theta_cp, (17)
  Array3<double> sauter_radius;               // r_32 [m], (19)
  Array3<double> liquid_ratio;                // lambda, (10); infinite: liquid without any solid
  std::vector<Array3<double>> species_ratio;  // lambda_i, (8)
  Array3<double> film_temperature;            // T_f,eq [K], (9); of no size without temperatures
};

}  // namespace gasgrain
