#include "gas_solver/gas_input.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "coupling/base/toml_input.h"

namespace gasgrain {
namespace {

std::vector<std::string> side_words() {
  return {side_names.begin(), side_names.end()};
}

// False when the grid is at fault: what must fit into it is then not checked against it.
bool read_grid(InputTable table, GasInput& input) {
  BoxGrid& grid = input.grid;
  grid.lo = table.vec3("lo", std::nullopt, Range::any(), "m");
  grid.hi = table.vec3("hi", std::nullopt, Range::any(), "m");
  grid.cells = table.int3("cells", std::nullopt, Range::within(1, 100000));
  bool usable = table.has("lo") && table.has("hi") && table.has("cells");
  for (int d = 0; d < 3 && usable; ++d) {
    if (!(grid.hi[d] > grid.lo[d])) {
      table.fault("hi", fmt::format("grid.hi must be above grid.lo along {}, but {} <= {}.",
                                    "xyz"[d], grid.hi[d], grid.lo[d]));
      usable = false;
    }
    usable = usable && grid.cells[d] > 0;
  }
  if (!usable) grid = BoxGrid{};
  return usable;
}

void read_gas(InputTable table, GasInput& input) {
  input.density = table.number("density", input.density, Range::positive(), "kg/m3");
  input.viscosity = table.number("viscosity", input.viscosity, Range::not_negative(), "Pa s");
  input.gravity = table.vec3("gravity", input.gravity, Range::any(), "m/s2");
}

void read_time(InputTable table, GasInput& input, bool alone) {
  input.step = table.number("step", input.step, Range::positive(), "s");
  input.courant_max = table.number("courant_max", input.courant_max, Range::positive(), "1");
  const std::optional<double> end = alone ? std::nullopt : std::optional<double>(0.0);
  input.end = table.number("end", end, Range::not_negative(), "s");
}

void read_sides(InputTable table, bool grid_known, GasInput& input) {
  std::vector<std::string> kinds;
  kinds.reserve(boundary_kinds.size());
  for (const BoundaryKind* kind : boundary_kinds) kinds.emplace_back(kind->name);
  for (int side = 0; side < side_count; ++side) {
    const std::string key(side_names[side]);
    const std::string name = table.choice(key, std::string(wall_no_slip.name), kinds);
    for (const BoundaryKind* kind : boundary_kinds)
      if (kind->name == name) input.sides[side] = kind;
  }
  input.outlet_pressure =
      table.number("outlet_pressure", input.outlet_pressure, Range::any(), "Pa");
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
  for (int side = 0; side < side_count && grid_known; ++side)
    if (input.sides[side] == &outlet && input.grid.cells[axis_of(side)] < 2)
      table.fault(std::string(side_names[side]),
                  fmt::format("boundary.{} = \"outlet\" needs at least 2 cells along {}.",
                              side_names[side], "xyz"[axis_of(side)]));
}

bool contains(const Rectangle& outer, const Rectangle& inner) {
  bool inside = true;
  for (int d = 0; d < 2; ++d) {
    const double round_off = 1e-9 * (outer.hi[d] - outer.lo[d]);
    inside =
        inside && inner.lo[d] >= outer.lo[d] - round_off && inner.hi[d] <= outer.hi[d] + round_off;
  }
  return inside;
}

std::string extent(const Rectangle& r, int side) {
  const auto plane = plane_axes(axis_of(side));
  return fmt::format("{} {} to {}, {} {} to {} m", "xyz"[plane[0]], r.lo[0], r.hi[0],
                     "xyz"[plane[1]], r.lo[1], r.hi[1]);
}

Outline read_outline(InputTable& table, const Rectangle& side) {
  const std::string shape = table.choice("shape", std::string("whole"),
                                         {inflow_shape_names.begin(), inflow_shape_names.end()});
  Outline outline{side, false};
  // The reader knows a key of one [[inflow]] in all of them: those of another shape are told here.
  const auto of_another_shape = [&](const char* key) {
    if (table.has(key))
      table.fault(key, fmt::format("inflow.{} does not go with shape = \"{}\": set the shape that "
                                   "has it, or leave it out.",
                                   key, shape));
  };
  if (shape != inflow_shape_names[static_cast<int>(InflowShape::rectangle)])
    of_another_shape("size");
  if (shape != inflow_shape_names[static_cast<int>(InflowShape::circle)])
    of_another_shape("diameter");
  if (shape == inflow_shape_names[static_cast<int>(InflowShape::whole)]) of_another_shape("center");
  if (shape == inflow_shape_names[static_cast<int>(InflowShape::whole)]) return outline;
  outline.round = shape == inflow_shape_names[static_cast<int>(InflowShape::circle)];
  const std::vector<double> middle{0.5 * (side.lo[0] + side.hi[0]),
                                   0.5 * (side.lo[1] + side.hi[1])};
  std::vector<double> center = table.numbers("center", std::nullopt, Range::any(), "m");
  std::vector<double> size;
  if (outline.round) {
    size.assign(2, table.number("diameter", std::nullopt, Range::positive(), "m"));
  } else {
    size = table.numbers("size", std::nullopt, Range::positive(), "m");
  }
  const auto two = [&](const char* key, std::vector<double>& values) {
    if (values.size() == 2) return;
    if (table.has(key))
      table.fault(key,
                  fmt::format("inflow.{} must have two values, in the plane of its side.", key));
    values = middle;
  };
  two("center", center);
  two("size", size);
  for (int d = 0; d < 2; ++d) {
    outline.bounds.lo[d] = center[d] - 0.5 * size[d];
    outline.bounds.hi[d] = center[d] + 0.5 * size[d];
  }
  return outline;
}

// Velocity from whichever of `velocity` and `mass_flow` is given.
double read_strength(InputTable& table, double density, double area) {
  const bool by_velocity = table.has("velocity");
  const bool by_mass = table.has("mass_flow");
  if (by_velocity == by_mass)
    table.fault("", fmt::format("[[inflow]] needs either velocity (m/s) or mass_flow (kg/s), {}.",
                                by_mass ? "not both" : "and has neither"));
  const double velocity = table.number("velocity", 0.0, Range::not_negative(), "m/s");
  const double mass_flow = table.number("mass_flow", 0.0, Range::not_negative(), "kg/s");
  return by_velocity ? velocity : mass_flow / (density * area);
}

void check_patch(InputTable& table, const GasInput& input, const InflowPatch& patch) {
  const Rectangle side = side_rectangle(input.grid, patch.side);
  const std::string_view name = side_names[patch.side];
  if (!input.sides[patch.side]->normal_velocity_given)
    table.fault("side", fmt::format("an inflow cannot lie on {}, which is \"{}\": make the side a "
                                    "wall, or move the inflow.",
                                    name, input.sides[patch.side]->name));
  if (input.grid.cells[axis_of(patch.side)] < 2)
    table.fault("side", fmt::format("an inflow on {} needs at least 2 cells along {}.", name,
                                    "xyz"[axis_of(patch.side)]));
  if (!contains(side, patch.outline.bounds))
    table.fault("center", fmt::format("the inflow covers {}, which leaves its side {}: {}.",
                                      extent(patch.outline.bounds, patch.side), name,
                                      extent(side, patch.side)));
  for (std::size_t n = 0; n < input.inflows.size(); ++n)
    if (input.inflows[n].side == patch.side && overlap(input.inflows[n].outline, patch.outline))
      table.fault("", fmt::format("the inflow ({}) overlaps the {}. inflow of the file ({}) on {}.",
                                  extent(patch.outline.bounds, patch.side), n + 1,
                                  extent(input.inflows[n].outline.bounds, patch.side), name));
}

void read_inflows(InputTable& root, bool grid_known, GasInput& input) {
  bool flows = false;
  std::vector<InputTable> tables = root.tables("inflow");
  for (InputTable& table : tables) {
    InflowPatch patch;
    const std::string name = table.choice("side", std::string(), side_words());
    if (!table.has("side")) table.fault("", "[[inflow]] lacks the key side.");
    const auto found = std::find(side_names.begin(), side_names.end(), name);
    if (found != side_names.end()) patch.side = static_cast<int>(found - side_names.begin());
    patch.outline = read_outline(table, side_rectangle(input.grid, patch.side));
    patch.velocity = read_strength(table, input.density, patch.outline.area());
    patch.ramp = table.number("ramp", 0.0, Range::not_negative(), "s");
    if (found != side_names.end() && grid_known) check_patch(table, input, patch);
    flows = flows || patch.velocity > 0;
    input.inflows.push_back(patch);
  }
  if (flows && !input.has_outlet())
    root.fault("inflow",
               "gas flows in but no side lets it out: set a side of [boundary] to \"outlet\".");
}

void read_solver(InputTable table, GasInput& input) {
  const std::string method =
      table.choice("pressure", std::string("auto"), {"auto", "hypre", "fftw"});
  input.pressure = method == "fftw"    ? PressureMethod::fftw
                   : method == "hypre" ? PressureMethod::hypre
                                       : PressureMethod::automatic;
  input.convection = table.choice("convection", std::string("tvd"), {"upwind", "tvd"}) == "tvd"
                         ? Convection::tvd
                         : Convection::upwind;
  input.tolerance = table.number("tolerance", input.tolerance, Range::within(1e-14, 1e-2), "1");
}

void read_measures(InputTable bed, InputTable output, bool grid_known, GasInput& input) {
  input.surface_solids =
      bed.number("surface_solids", input.surface_solids, Range::within(0, 1), "1");
  input.bubble_void_fraction =
      bed.number("bubble_void_fraction", input.bubble_void_fraction, Range::within(0, 1), "1");
  input.output_every = output.number("every", input.output_every, Range::not_negative(), "s");
  input.pressure_probes =
      output.numbers("pressure_probes", std::vector<double>{}, Range::any(), "m");
  if (input.pressure_probes.size() > most_pressure_probes)
    output.fault("pressure_probes",
                 fmt::format("output.pressure_probes has {} heights, at most {} fit.",
                             input.pressure_probes.size(), most_pressure_probes));
  for (const double z : input.pressure_probes)
    if (grid_known && (z < input.grid.lo[2] || z > input.grid.hi[2]))
      output.fault("pressure_probes",
                   fmt::format("the pressure probe at z = {} m is outside of the grid, {} to {} m.",
                               z, input.grid.lo[2], input.grid.hi[2]));
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
  InputTable root = toml.root();
  GasInput input;
  const bool grid_known = read_grid(root.table("grid"), input);
  read_gas(root.table("gas"), input);
  read_time(root.table("time"), input, alone);
  read_sides(root.table("boundary"), grid_known, input);
  read_inflows(root, grid_known, input);
  read_solver(root.table("solver"), input);
  read_measures(root.table("bed"), root.table("output"), grid_known, input);
  toml.finish();
  return input;
}

}  // namespace gasgrain
