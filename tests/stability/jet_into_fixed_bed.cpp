// A jet of 100 m/s through one cell into a packed bed, switched on in one step and off in one step,
// and gas drawn in through the outlet, seen from the gas. The drag of Ergun's equation follows the
// velocity from step to step. The naive way takes it from the step before, as a force: the
// product's source S in place of its coefficient K.
#include <gtest/gtest.h>

#include "tests/stability/coupled_bed.h"

namespace gasgrain::stability {
namespace {

constexpr double jet = 100.0;      // [m/s]
constexpr double diameter = 2e-3;  // of the grains [m]
constexpr double bed_eps = 0.42;
constexpr double interval = 5e-4;  // [s]
constexpr int bed_layers = 20;

GasInput scene() {
  GasInput input = gas_cases::thin_jet();
  input.inflows[0].velocity = jet;
  input.tolerance = 1e-8;
  return input;
}

// S. Ergun, Chem. Eng. Prog. 48 (1952) 89, per volume of bed and interstitial velocity.
double ergun(const GasInput& input, double speed) {
  const double solids = 1.0 - bed_eps;
  return 150.0 * solids * solids * input.viscosity / (bed_eps * diameter * diameter) +
         1.75 * solids * input.density * speed / diameter;
}

void charge(GasSolver& gas, const GasInput& input, bool implicit) {
  const CellVector u = gas.cell_velocity();
  Array3<double> drag(gas.own());
  CellVector source{drag, drag, drag};
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    if (k >= bed_layers) return;
    const Vec3 here(u[0](i, j, k), u[1](i, j, k), u[2](i, j, k));
    const double coefficient = ergun(input, here.norm());
    if (implicit)
      drag(i, j, k) = coefficient;
    else
      for (int d = 0; d < 3; ++d) source[d](i, j, k) = -coefficient * here[d];
  });
  gas.set_drag(drag, source);
}

void fill_bed(GasSolver& gas) {
  gas.set_void_fraction(
      gas_cases::filled(gas.own(), [](int, int, int k) { return k < bed_layers ? bed_eps : 1.0; }));
}

double greatest(const Array3<double>& field) {
  return *std::max_element(field.begin(), field.end());
}

void expect_in_order(const GasReport& report) {
  EXPECT_LT(report.continuity_residual, 1e-6);
  EXPECT_LT(report.mass_imbalance, 1e-12);
  EXPECT_EQ(report.pressure_not_converged, 0);
  EXPECT_EQ(report.momentum_not_converged, 0);
}

TEST(jet_into_fixed_bed, of_100_m_s_comes_and_goes_in_one_step) {
  GasInput input = scene();
  constexpr double off = 0.01;
  input.inflows[0].table_times = {off + 0.25 * interval, off + 0.5 * interval};
  input.inflows[0].table_factors = {1.0, 0.0};
  GasSolver gas(input, self());
  fill_bed(gas);
  const double full = input.density * jet * input.inflows[0].outline.area();
  double most_pressure = 0.0;
  while (gas.time() < off - 0.5 * interval) {
    charge(gas, input, true);
    const GasReport report = gas.advance(interval);
    expect_in_order(report);
    EXPECT_NEAR(report.mass_inflow, full, 1e-12 * full);
    EXPECT_NEAR(report.mass_outflow, full, 1e-6 * full);
    // The first step meets gas at rest and knows nothing yet of the velocity that the drag will
    // see.
    EXPECT_LT(gas_cases::greatest_speed(gas), 1.2 * jet) << gas.time();
    most_pressure = std::max(most_pressure, greatest(gas.pressure()));
  }
  // It builds up without overshoot.
  EXPECT_LT(most_pressure, 1.001 * greatest(gas.pressure()));

  double speed = gas_cases::greatest_speed(gas);
  const double at_rest = input.density * 9.81 * input.grid.hi[2];
  while (gas.time() < 2 * off - 0.5 * interval) {
    charge(gas, input, true);
    expect_in_order(gas.advance(interval));
    EXPECT_LT(gas_cases::greatest_speed(gas), 0.1 * jet) << gas.time();
    speed = gas_cases::greatest_speed(gas);
  }
  EXPECT_LT(speed, 1e-3 * jet);
  EXPECT_NEAR(greatest(gas.pressure()), at_rest, 0.05 * at_rest);
}

TEST(jet_into_fixed_bed, reversed_at_the_outlet_draws_in_what_the_bed_loses) {
  GasInput input = scene();
  const double rate = input.density * jet * input.inflows[0].outline.area();
  input.inflows.clear();
  GasSolver gas(input, self());
  fill_bed(gas);
  // From blowing through the bed to drawing through it, in one step and back.
  const double cells = input.grid.cells[0] * input.grid.cells[1];
  const double plug = rate / (input.density * input.grid.hi[0] * input.grid.hi[1]);
  for (int n = 0; n < 30; ++n) {
    const double sign = n / 10 == 1 ? -1.0 : 1.0;
    Array3<double> source(gas.own());
    for_each_cell(gas.own(), [&](int i, int j, int k) {
      if (k == 0) source(i, j, k) = sign * rate / (cells * gas.grid().cell_volume());
    });
    gas.set_mass_source(source);
    charge(gas, input, true);
    const GasReport report = gas.advance(interval);
    expect_in_order(report);
    EXPECT_NEAR(report.mass_outflow, sign * rate, 1e-6 * rate) << n;
    EXPECT_EQ(report.backflow_faces, sign < 0 ? static_cast<long>(cells) : 0) << n;
    // Evenly over the section, as nothing disturbs it.
    EXPECT_LT(gas_cases::greatest_speed(gas), 1.01 * plug / bed_eps) << n;
  }
}

TEST(jet_into_fixed_bed, with_drag_of_the_step_before_runs_away) {
  const GasInput input = scene();
  GasSolver gas(input, self());
  fill_bed(gas);
  int steps = 0;
  while (steps < 20 && gas_cases::greatest_speed(gas) < 20 * jet) {
    charge(gas, input, false);
    gas.advance(interval);
    ++steps;
  }
  std::printf("explicit drag: %.3g m/s after %d steps of %g s\n", gas_cases::greatest_speed(gas),
              steps, interval);
  EXPECT_GT(gas_cases::greatest_speed(gas), 20 * jet);
}

}  // namespace
}  // namespace gasgrain::stability
