#include <fmt/format.h>

#include "gas_solver/input/named_choice.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {
namespace {

// Without damping, jets of one cell stay quiet to a Courant number of 4 and grow slowly at 10.
constexpr double courant_crank_nicolson = 2;

// SIMPLEC's pressure takes the neighbours' change along, and hence no relaxation. 0.9 needed the
// fewest outer iterations of 0.7 to 0.95 on the manufactured solution of tests/convergence.
constexpr double relax_velocity_simplec = 0.9;
constexpr double relax_pressure_simplec = 1.0;

void read_outer_iterations(InputTable& table, GasInput& input) {
  const bool simple = input.pressure_velocity == PressureVelocity::simple;
  const bool simplec = input.pressure_velocity == PressureVelocity::simplec;
  InputTable outer = table.when(input.pressure_velocity != PressureVelocity::projection,
                                "pressure_velocity = \"simple\" or \"simplec\"");
  input.outer_iterations =
      outer.integer("outer_iterations", input.outer_iterations, Range::within(1, 1000));
  input.outer_tolerance =
      outer.number("outer_tolerance", input.outer_tolerance, Range::within(1e-14, 1), "1");
  const auto relaxation = [&](const char* key, double of_simple, double of_simplec) {
    const double value =
        outer.number(key, simplec ? of_simplec : of_simple, Range::positive_up_to(1), "1");
    outer.note_default(key, fmt::format("{}, {} of \"simplec\"", of_simple, of_simplec));
    return value;
  };
  input.relax_velocity = relaxation("relax_velocity", input.relax_velocity, relax_velocity_simplec);
  input.relax_pressure = relaxation("relax_pressure", input.relax_pressure, relax_pressure_simplec);
  if (simple && input.law == GasLaw::ideal_gas)
    table.fault("pressure_velocity",
                "solver.pressure_velocity = \"simple\" does not go with [gas] law = \"ideal_gas\", "
                "whose density must take the whole of a pressure correction: use \"simplec\" or "
                "\"projection\".");
  if (simplec && input.law == GasLaw::ideal_gas && input.relax_pressure < 1)
    table.fault(
        "relax_pressure",
        "solver.relax_pressure must be 1 with [gas] law = \"ideal_gas\", whose density must "
        "take the whole of a pressure correction: leave it out.");
}

}  // namespace

void read_time(InputTable table, bool alone, GasInput& input) {
  input.step = table.number("step", input.step, Range::positive(), "s");
  input.scheme = named_choice(table, "scheme", input.scheme,
                              {{"implicit_euler", TimeScheme::implicit_euler},
                               {"crank_nicolson", TimeScheme::crank_nicolson}});
  const bool middle = input.scheme == TimeScheme::crank_nicolson;
  const double courant = middle ? courant_crank_nicolson : input.courant_max;
  input.courant_max = table.number("courant_max", courant, Range::positive(), "1");
  table.note_default("courant_max", fmt::format("{}, {} of \"crank_nicolson\"", input.courant_max,
                                                courant_crank_nicolson));
  input.substeps_max = table.integer("substeps_max", input.substeps_max, Range::within(1, 1000000));
  const std::optional<double> end = alone ? std::nullopt : std::optional<double>(0.0);
  input.end = table.number("end", end, Range::not_negative(), "s");
  table.note_default("end", "required alone");
  if (input.end / input.step > most_steps && !table.at_fault("step"))
    table.fault("end",
                fmt::format("time.end = {} s takes {:.3g} steps of time.step = {} s, at most "
                            "{:.0e} fit: raise time.step to {:.3g} s, or lower time.end.",
                            input.end, input.end / input.step, input.step, most_steps,
                            step_that_fits(input.end)));
}

void read_solver(InputTable table, GasInput& input) {
  input.pressure = named_choice(table, "pressure", input.pressure,
                                {{"auto", PressureMethod::automatic},
                                 {"multigrid", PressureMethod::multigrid},
                                 {"hypre", PressureMethod::hypre},
                                 {"fftw", PressureMethod::fftw}});
  int axes_with_outlets = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (input.sides[side_of(axis, false)] == &outlet || input.sides[side_of(axis, true)] == &outlet)
      ++axes_with_outlets;
  if (input.pressure == PressureMethod::fftw && axes_with_outlets > 1)
    table.fault(
        "pressure",
        "solver.pressure = \"fftw\" cannot solve with outlets on the sides of more than one "
        "axis: use \"auto\" or \"multigrid\".");
  input.tolerance = table.number("tolerance", input.tolerance, Range::within(1e-14, 1e-2), "1");
  input.convection = named_choice(table, "convection", input.convection,
                                  {{"upwind", Convection::upwind},
                                   {"central", Convection::central},
                                   {"blend", Convection::blend},
                                   {"quick", Convection::quick},
                                   {"tvd", Convection::tvd}});
  input.blend = table.when(input.convection == Convection::blend, "convection = \"blend\"")
                    .number("blend", input.blend, Range::within(0, 1), "1");
  input.correction_passes = table.integer("correction_passes", 0, Range::within(1, 50));
  table.note_default("correction_passes", "1, 3 of \"crank_nicolson\" with the projection");
  input.pressure_velocity = named_choice(table, "pressure_velocity", input.pressure_velocity,
                                         {{"projection", PressureVelocity::projection},
                                          {"simple", PressureVelocity::simple},
                                          {"simplec", PressureVelocity::simplec}});
  read_outer_iterations(table, input);
}

}  // namespace gasgrain
