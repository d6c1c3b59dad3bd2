// What a run of the gas solver is told: gas.toml, read and checked, or filled in by a test.
// docs/gas-solver.md explains every key.
#pragma once

#include <string>
#include <vector>

#include "coupling/base/box_grid.h"
#include "gas_solver/boundary/inflow.h"
#include "gas_solver/boundary/kinds.h"

namespace gasgrain {

enum class PressureMethod { automatic, hypre, fftw };
enum class Convection { upwind, tvd };

// Probes that a report to the DEM program has room for.
inline constexpr std::size_t most_pressure_probes = 16;

struct GasInput {
  BoxGrid grid;  // its `periodic` follows from `sides`

  double density = 1.2;           // [kg/m3] air at 293 K and 1 atm
  double viscosity = 18.27e-6;    // [Pa s]  air at 291 K
  Vec3 gravity{0.0, 0.0, -9.81};  // [m/s2]

  double step = 1e-3;       // greatest step of time [s]
  double courant_max = 20;  // greatest Courant number
  double end = 0;           // end of a run without particles [s]

  Sides sides{&wall_no_slip, &wall_no_slip, &wall_no_slip,
              &wall_no_slip, &wall_no_slip, &wall_no_slip};
  double outlet_pressure = 0;  // [Pa]
  std::vector<InflowPatch> inflows;

  PressureMethod pressure = PressureMethod::automatic;
  Convection convection = Convection::tvd;
  double tolerance = 1e-6;

  double surface_solids = 0.1;
  double bubble_void_fraction = 0.8;

  double output_every = 0;              // [s], 0: no snapshots
  std::vector<double> pressure_probes;  // heights z [m]

  [[nodiscard]] bool has_outlet() const;
  // Sets the grid's periodic axes from the sides.
  void join_periodic_sides();
};

// Throws Error with all faults of the file. A run without particles requires [time] end.
GasInput read_gas_input(const std::string& file, bool alone);

}  // namespace gasgrain
