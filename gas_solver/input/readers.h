// Readers of the tables of gas.toml, one a table, in the order in which they need each other.
#pragma once

#include "coupling/base/toml_input.h"
#include "gas_solver/gas_input.h"

namespace gasgrain {

// Of a run: beyond, times are no longer told apart.
inline constexpr double most_steps = 1e9;
// A length of a step that fits, for messages: three digits of it are not too short.
inline double step_that_fits(double end) {
  return 1.01 * end / most_steps;
}

// False when the grid is at fault: what must fit into it is then not checked against it.
bool read_grid(InputTable table, GasInput& input);
void read_gas(InputTable table, GasInput& input);
// `alone`: without particles, which else tell the end of the run.
void read_time(InputTable table, bool alone, GasInput& input);
void read_boundary(InputTable table, bool grid_known, GasInput& input);
void read_inflows(InputTable& root, bool grid_known, GasInput& input);
void read_mass_sources(InputTable& root, bool grid_known, GasInput& input);
void read_solver(InputTable table, GasInput& input);
void read_turbulence(InputTable table, GasInput& input);
void read_measures(InputTable bed, InputTable output, bool grid_known, GasInput& input);

// What no table can tell alone: gas that comes in must get out, or be compressed.
void check_balance(InputTable& root, const GasInput& input);

}  // namespace gasgrain
