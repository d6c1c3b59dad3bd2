// What a run of the gas solver is told: gas.toml, read and checked, or filled in by a test.
// docs/gas-input.md explains every key.
#pragma once

#include <string>
#include <vector>

#include "coupling/base/box_grid.h"
#include "gas_solver/boundary/inflow.h"
#include "gas_solver/boundary/kinds.h"
#include "gas_solver/operators/convection/schemes.h"

namespace gasgrain {

enum class PressureMethod { automatic, multigrid, hypre, fftw };
enum class TimeScheme { implicit_euler, crank_nicolson };
enum class PressureVelocity { projection, simple, simplec };
enum class GasLaw { constant_density, ideal_gas };
// Where the pressure gradient acts: on the gas' share of a cell (A), or whole on the gas (B).
enum class GasModel { a, b };
enum class TurbulenceModel { none, smagorinsky, k_epsilon };

inline constexpr double gas_constant = 8.31446261815324;  // R [J/(mol K)], SI 2019

// A box in which gas appears, e.g. from evaporation.
struct MassSource {
  Vec3 lo = Vec3::Zero();
  Vec3 hi = Vec3::Zero();
  double rate = 0;  // of the whole box [kg/s]; negative: gas disappears
};

// [turbulence] of gas.toml.
struct TurbulenceInput {
  TurbulenceModel model = TurbulenceModel::none;
  double smagorinsky_constant = 0.1;
  double intensity = 0.05;  // of what flows in: sqrt(2 k / 3) / |U|
  double length_scale = 0;  // of what flows in [m]; 0: 0.07 of the patch's hydraulic diameter
};

// Probes that a report to the DEM program has room for.
inline constexpr std::size_t most_pressure_probes = 16;

struct GasInput {
  BoxGrid grid;  // its `periodic` follows from `sides`

  double density = 1.2;  // [kg/m3] air at 293 K and 1 atm
  GasLaw law = GasLaw::constant_density;
  // Of an ideal gas, whose density is reference_pressure M / (R T) where the gauge pressure is 0:
  double reference_pressure = 101325;  // absolute, where the gauge pressure is 0 [Pa]
  double temperature = 293.15;         // [K]
  double molar_mass = 28.965e-3;       // [kg/mol] air
  double viscosity = 18.27e-6;         // [Pa s]  air at 291 K
  GasModel model = GasModel::a;
  Vec3 gravity{0.0, 0.0, -9.81};  // [m/s2]

  double step = 1e-3;       // greatest step of time [s]
  double courant_max = 20;  // greatest Courant number
  int substeps_max = 1000;  // that it may split one of them into
  double end = 0;           // end of a run without particles [s]
  TimeScheme scheme = TimeScheme::implicit_euler;

  Sides sides{&wall_no_slip, &wall_no_slip, &wall_no_slip,
              &wall_no_slip, &wall_no_slip, &wall_no_slip};
  std::array<Vec3, 6> wall_velocity{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                    Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // [m/s]
  double outlet_pressure = 0;                                                   // gauge [Pa]
  std::vector<InflowPatch> inflows;
  std::vector<MassSource> mass_sources;
  // Of a grid one cell deep along y: > 0 makes it a plane of spheres, see plane_of_spheres.h [m].
  double plane_of_spheres = 0;

  PressureMethod pressure = PressureMethod::automatic;
  Convection convection = Convection::tvd;
  double blend = 0.5;         // share of upwind in "blend"
  int correction_passes = 0;  // of the explicit parts of a step, 0: 1 or (Crank-Nicolson) 3
  PressureVelocity pressure_velocity = PressureVelocity::projection;
  // Of SIMPLE and SIMPLEC.
  int outer_iterations = 50;
  double outer_tolerance = 1e-5;
  double relax_velocity = 0.7;
  double relax_pressure = 0.3;
  double tolerance = 1e-6;

  TurbulenceInput turbulence;

  double surface_solids = 0.1;
  double bubble_void_fraction = 0.8;

  double output_every = 0;              // [s], 0: no snapshots
  double checkpoint_every = 0;          // of a run alone [s], 0: at the end only
  std::vector<double> pressure_probes;  // heights z [m]

  [[nodiscard]] bool has_outlet() const;
  [[nodiscard]] Walls walls() const { return {sides, wall_velocity}; }
  // Sets the grid's periodic axes from the sides.
  void join_periodic_sides();
};

// Throws Error with all faults of the file. A run without particles requires [time] end.
GasInput read_gas_input(const std::string& file, bool alone);

// Every key of the file with its unit, range and default, as lines of a Markdown table.
std::string gas_input_keys();

}  // namespace gasgrain
