#include "coupling/base/error.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {

void read_measures(InputTable bed, InputTable output, bool grid_known, GasInput& input) {
  input.surface_solids =
      bed.number("surface_solids", input.surface_solids, Range::within(0, 1), "1");
  input.bubble_void_fraction =
      bed.number("bubble_void_fraction", input.bubble_void_fraction, Range::within(0, 1), "1");
  input.output_every = output.number("every", input.output_every, Range::not_negative(), "s");
  if (input.end > most_steps * input.output_every && input.output_every > 0)
    output.fault("every", fmt::format("output.every = {} s makes {:.3g} snapshots until time.end = "
                                      "{} s, at most {:.0e} fit: raise it to {:.3g} s, or leave it "
                                      "out.",
                                      input.output_every, input.end / input.output_every, input.end,
                                      most_steps, step_that_fits(input.end)));
  input.checkpoint_every =
      output.number("checkpoint_every", input.checkpoint_every, Range::not_negative(), "s");
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

}  // namespace gasgrain
