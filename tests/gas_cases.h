// Small cases that tests of the gas solver share.
#pragma once

#include <functional>

#include "gas_solver/gas_step.h"

namespace gasgrain::gas_cases {

inline Communicator self() {
  return Communicator(MPI_COMM_SELF);
}

using Field = std::function<double(int i, int j, int k)>;

inline GasInput box(const Int3& cells, const Vec3& size, const Sides& sides) {
  GasInput input;
  input.grid.hi = size;
  input.grid.cells = cells;
  input.sides = sides;
  return input;
}

// The same with air as an ideal gas.
inline GasInput ideal_gas(GasInput input) {
  input.law = GasLaw::ideal_gas;
  input.density = input.reference_pressure * input.molar_mass / (gas_constant * input.temperature);
  return input;
}

inline constexpr Sides walls{&wall_no_slip, &wall_no_slip, &wall_no_slip,
                             &wall_no_slip, &wall_no_slip, &wall_no_slip};
// A column without friction, open at its top.
inline constexpr Sides column{&wall_free_slip, &wall_free_slip, &wall_free_slip,
                              &wall_free_slip, &wall_free_slip, &outlet};

inline InflowPatch whole_side(const GasInput& input, int side, double velocity) {
  return {side, {side_rectangle(input.grid, side), false}, velocity, 0.0, 0.0, {}, {}};
}

inline InflowPatch jet_through(const Outline& outline, double velocity) {
  InflowPatch jet;
  jet.side = 4;
  jet.outline = outline;
  jet.velocity = velocity;
  return jet;
}

// A round jet into a box that is open at its top.
inline GasInput spout(const Int3& cells, double velocity, double tolerance) {
  GasInput input = box(cells, Vec3(0.06, 0.05, 0.14), walls);
  input.sides[5] = &outlet;
  input.inflows = {jet_through({{{0.021, 0.011}, {0.039, 0.029}}, true}, velocity)};
  input.tolerance = tolerance;
  return input;
}

// The same, endless along y.
inline GasInput endless_spout(const Int3& cells, double velocity, double tolerance) {
  GasInput input = spout(cells, velocity, tolerance);
  input.sides[2] = input.sides[3] = &periodic_side;
  return input;
}

// A jet through the only cell that its nozzle covers.
inline GasInput thin_jet() {
  GasInput input = box({12, 6, 40}, Vec3(0.048, 0.024, 0.16), walls);
  input.sides[5] = &outlet;
  input.inflows = {jet_through({{{0.024, 0.012}, {0.028, 0.016}}, false}, 150)};
  return input;
}

inline Array3<double> filled(const IndexBox& box, const Field& value) {
  Array3<double> field(box);
  for_each_cell(box, [&](int i, int j, int k) { field(i, j, k) = value(i, j, k); });
  return field;
}

inline void set_bed(GasSolver& gas, const Field& eps, const Field& drag, const Field& source_z) {
  const Array3<double> none(gas.own());
  gas.set_void_fraction(filled(gas.own(), eps));
  gas.set_drag(filled(gas.own(), drag), {none, none, filled(gas.own(), source_z)});
}

// A number in [0, 1) that depends on the cell alone, so that ranks agree on it.
inline double scatter(int i, int j, int k) {
  const double x = 12.9898 * i + 78.233 * j + 37.719 * k;
  const double y = 43758.5453 * std::sin(x);
  return y - std::floor(y);
}

// The steps `from` to `to` of a spout over a bed that scatters, another one every step; what the
// last one reports.
inline GasReport run_spout(GasSolver& gas, int from, int to) {
  GasReport report;
  for (int n = from; n < to; ++n) {
    set_bed(
        gas,
        [n](int i, int j, int k) {
          return 0.4 + (k < 7 ? 0.0 : 0.58) + 0.02 * scatter(i + n, j, k);
        },
        [](int i, int j, int k) { return 2e3 * scatter(k, i, j); },
        [](int i, int j, int k) { return 30 * scatter(j, k, i); });
    report = gas.advance(1e-3);
  }
  return report;
}

inline double constant_zero(int, int, int) {
  return 0.0;
}

inline double greatest_speed(const GasSolver& gas) {
  double greatest = 0;
  for (int d = 0; d < 3; ++d)
    for_each_cell(gas.domain().faces(d), [&](int i, int j, int k) {
      greatest = std::max(greatest, std::abs(gas.state().velocity[d](i, j, k)));
    });
  return greatest;
}

}  // namespace gasgrain::gas_cases
