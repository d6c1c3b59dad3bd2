#include <algorithm>

#include "coupling/base/error.h"
#include "gas_solver/input/inflow_outline.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {
namespace {

// From whichever of `velocity` and `mass_flow` is given.
void read_strength(InputTable& table, double density, InflowPatch& patch) {
  const bool by_velocity = table.has("velocity");
  const bool by_mass = table.has("mass_flow");
  if (by_velocity == by_mass)
    table.fault("", fmt::format("[[inflow]] needs either velocity (m/s) or mass_flow (kg/s), {}.",
                                by_mass ? "not both" : "and has neither"));
  patch.velocity = table.number("velocity", 0.0, Range::not_negative(), "m/s");
  patch.mass_flow = table.number("mass_flow", 0.0, Range::not_negative(), "kg/s");
  for (const char* key : {"velocity", "mass_flow"})
    table.note_default(key, "one of `velocity`, `mass_flow` is required");
  if (by_mass) patch.velocity = patch.full_velocity(density);
}

void read_course(InputTable& table, InflowPatch& patch) {
  patch.ramp = table.number("ramp", 0.0, Range::not_negative(), "s");
  for (const auto& [time, factor] :
       table.pairs("table", Range::not_negative(), "time in s", "factor")) {
    if (!patch.table_times.empty() && time <= patch.table_times.back())
      table.fault("table", fmt::format("the times of inflow.table must rise, but {} s follows {} "
                                       "s.",
                                       time, patch.table_times.back()));
    patch.table_times.push_back(time);
    patch.table_factors.push_back(factor);
  }
  if (table.has("ramp") && table.has("table"))
    table.fault("ramp",
                "inflow.ramp and inflow.table exclude each other: put the ramp into the table, "
                "[[0, 0], [ramp, 1], ...].");
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
                                      extent_text(patch.outline.bounds, patch.side), name,
                                      extent_text(side, patch.side)));
  for (std::size_t n = 0; n < input.inflows.size(); ++n)
    if (input.inflows[n].side == patch.side && overlap(input.inflows[n].outline, patch.outline))
      table.fault("", fmt::format("the inflow ({}) overlaps the {}. inflow of the file ({}) on {}.",
                                  extent_text(patch.outline.bounds, patch.side), n + 1,
                                  extent_text(input.inflows[n].outline.bounds, patch.side), name));
}

}  // namespace

void read_inflows(InputTable& root, bool grid_known, GasInput& input) {
  for (InputTable& table : root.tables("inflow")) {
    InflowPatch patch;
    // Without a default to fall back on: a patch on no side is not checked against one.
    const std::string name =
        table.choice("side", std::string(), {side_names.begin(), side_names.end()});
    table.note_default("side", "required");
    if (!table.has("side")) table.fault("", "[[inflow]] lacks the key side.");
    const auto found = std::find(side_names.begin(), side_names.end(), name);
    if (found != side_names.end()) patch.side = static_cast<int>(found - side_names.begin());
    patch.outline = read_outline(table, side_rectangle(input.grid, patch.side));
    read_strength(table, input.density, patch);
    read_course(table, patch);
    if (found != side_names.end() && grid_known) check_patch(table, input, patch);
    input.inflows.push_back(patch);
  }
}

}  // namespace gasgrain
