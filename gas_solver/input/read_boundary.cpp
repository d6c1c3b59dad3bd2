#include <algorithm>

#include "coupling/base/error.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {
namespace {

void read_kinds(InputTable& table, GasInput& input) {
  std::vector<std::string> kinds;
  kinds.reserve(boundary_kinds.size());
  for (const BoundaryKind* kind : boundary_kinds) kinds.emplace_back(kind->name);
  for (int side = 0; side < side_count; ++side) {
    const std::string key(side_names[side]);
    const std::string name = table.choice(key, std::string(wall_no_slip.name), kinds);
    for (const BoundaryKind* kind : boundary_kinds)
      if (kind->name == name) input.sides[side] = kind;
  }
}

void check_periodic(InputTable& table, GasInput& input) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool lo = input.sides[side_of(axis, false)]->periodic;
    const bool hi = input.sides[side_of(axis, true)]->periodic;
    if (lo == hi) continue;
    const std::string is(side_names[side_of(axis, !lo)]);
    const std::string is_not(side_names[side_of(axis, lo)]);
    table.fault(is, fmt::format("boundary.{} is \"periodic\" but {} is not: set both, or neither.",
                                is, is_not));
    input.sides[side_of(axis, false)] = input.sides[side_of(axis, true)] = &periodic_side;
  }
  input.join_periodic_sides();
}

void read_wall_velocities(InputTable& table, GasInput& input) {
  for (int side = 0; side < side_count; ++side) {
    const std::string key = std::string(side_names[side]) + "_velocity";
    const Vec3 velocity = table
                              .when(input.sides[side] == &wall_no_slip, "a \"no_slip\" side",
                                    "make the side \"no_slip\", or leave the key out")
                              .vec3(key, Vec3(Vec3::Zero()), Range::any(), "m/s");
    const int normal = axis_of(side);
    if (velocity[normal] != 0)
      table.fault(key, fmt::format("boundary.{} has {} m/s along {}, but a wall moves in its own "
                                   "plane only: set that to 0, or make it an [[inflow]].",
                                   key, velocity[normal], "xyz"[normal]));
    else
      input.wall_velocity[side] = velocity;
  }
}

void read_outlet_pressure(InputTable& table, GasInput& input) {
  constexpr const char* key = "outlet_pressure";
  input.outlet_pressure = table.when(input.has_outlet(), "an \"outlet\" side")
                              .number(key, input.outlet_pressure, Range::any(), "Pa");
  if (input.law == GasLaw::ideal_gas && !(input.reference_pressure + input.outlet_pressure > 0))
    table.fault(key, fmt::format("boundary.outlet_pressure = {} is gauge: with gas.pressure = {} "
                                 "it makes an absolute pressure that is not above 0 Pa.",
                                 input.outlet_pressure, input.reference_pressure));
}

}  // namespace

void read_boundary(InputTable table, bool grid_known, GasInput& input) {
  read_kinds(table, input);
  read_outlet_pressure(table, input);
  check_periodic(table, input);
  read_wall_velocities(table, input);
  for (int side = 0; side < side_count && grid_known; ++side)
    if (input.sides[side] == &outlet && input.grid.cells[axis_of(side)] < 2)
      table.fault(std::string(side_names[side]),
                  fmt::format("boundary.{} = \"outlet\" needs at least 2 cells along {}.",
                              side_names[side], "xyz"[axis_of(side)]));
}

}  // namespace gasgrain
