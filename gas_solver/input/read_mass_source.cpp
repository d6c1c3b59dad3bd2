#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {
namespace {

void check_box(InputTable& table, const BoxGrid& grid, const MassSource& source) {
  for (int d = 0; d < 3; ++d) {
    if (!(source.hi[d] > source.lo[d]))
      table.fault("hi", fmt::format("mass_source.hi must be above lo along {}, but {} <= {}.",
                                    "xyz"[d], source.hi[d], source.lo[d]));
    else if (!(source.hi[d] > grid.lo[d] && source.lo[d] < grid.hi[d]))
      table.fault("lo", fmt::format("the mass source lies outside of the grid: along {} it covers "
                                    "{} to {} m, the grid {} to {} m.",
                                    "xyz"[d], source.lo[d], source.hi[d], grid.lo[d], grid.hi[d]));
  }
}

}  // namespace

void read_mass_sources(InputTable& root, bool grid_known, GasInput& input) {
  for (InputTable& table : root.tables("mass_source")) {
    MassSource source;
    source.lo = table.vec3("lo", std::nullopt, Range::any(), "m");
    source.hi = table.vec3("hi", std::nullopt, Range::any(), "m");
    source.rate = table.number("rate", std::nullopt, Range::any(), "kg/s");
    const auto right = [&](const char* key) { return table.has(key) && !table.at_fault(key); };
    if (grid_known && right("lo") && right("hi")) check_box(table, input.grid, source);
    input.mass_sources.push_back(source);
  }
}

void check_balance(InputTable& root, const GasInput& input) {
  if (input.has_outlet() || input.law == GasLaw::ideal_gas) return;
  constexpr const char* remedy =
      "set a side of [boundary] to \"outlet\", or gas.law to \"ideal_gas\"";
  if (std::any_of(input.inflows.begin(), input.inflows.end(),
                  [](const InflowPatch& patch) { return patch.velocity > 0; }))
    root.fault(
        "inflow",
        fmt::format("gas of constant density flows in but no side lets it out: {}.", remedy));
  double sum = 0;
  double size = 0;
  for (const MassSource& source : input.mass_sources) {
    sum += source.rate;
    size += std::abs(source.rate);
  }
  constexpr double round_off = 1e-9;
  if (std::abs(sum) > round_off * size)
    root.fault("mass_source",
               fmt::format("in a box without an outlet the rates of the mass sources of gas of "
                           "constant density must sum to 0, they sum to {} kg/s: {}.",
                           sum, remedy));
}

}  // namespace gasgrain
