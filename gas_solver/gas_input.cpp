#include "gas_solver/gas_input.h"

#include <algorithm>

#include "gas_solver/input/readers.h"

namespace gasgrain {
namespace {

GasInput read(InputTable root, bool alone) {
  GasInput input;
  const bool grid_known = read_grid(root.table("grid"), input);
  read_gas(root.table("gas"), input);
  read_time(root.table("time"), alone, input);
  read_boundary(root.table("boundary"), grid_known, input);
  read_inflows(root, grid_known, input);
  read_mass_sources(root, grid_known, input);
  check_balance(root, input);
  read_solver(root.table("solver"), input);
  read_turbulence(root.table("turbulence"), input);
  read_measures(root.table("bed"), root.table("output"), grid_known, input);
  return input;
}

}  // namespace

bool GasInput::has_outlet() const {
  return std::any_of(sides.begin(), sides.end(), [](const BoundaryKind* kind) {
    return !kind->normal_velocity_given && !kind->periodic;
  });
}

void GasInput::join_periodic_sides() {
  for (int axis = 0; axis < 3; ++axis) grid.periodic[axis] = sides[side_of(axis, false)]->periodic;
}

GasInput read_gas_input(const std::string& file, bool alone) {
  TomlInput toml(file);
  GasInput input = read(toml.root(), alone);
  toml.finish();
  return input;
}

std::string gas_input_keys() {
  return TomlInput::key_table([](InputTable root) { read(root, true); });
}

}  // namespace gasgrain
