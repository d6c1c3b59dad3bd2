// Balances of the gas solver: rest, mass, drag impulse, pressure drop.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

double random_void_fraction(int i, int j, int k) {
  return 0.35 + 0.65 * scatter(i, j, k);
}

TEST(gas_balance, gas_at_rest_under_gravity_stays_at_rest_in_any_void_fraction) {
  for (const int outlet_side : {5, 0, -1}) {
    Sides sides = walls;
    if (outlet_side >= 0) sides[outlet_side] = &outlet;
    GasInput input = box({6, 5, 12}, Vec3(0.06, 0.05, 0.12), sides);
    input.gravity = Vec3(1.0, -2.0, -9.81);
    GasSolver gas(input, self());
    set_bed(
        gas, random_void_fraction, [](int i, int j, int k) { return 1e4 * scatter(k, i, j); },
        constant_zero);
    for (int n = 0; n < 10; ++n) gas.advance(1e-3);
    // The hydrostatic pressure is kept apart, so that nothing is left to round off.
    EXPECT_LT(greatest_speed(gas), 1e-10);
    const double weight = gas.mean_pressure_gradient()[2](3, 2, 5);
    EXPECT_NEAR(weight, -9.81 * input.density, 1e-10);
  }
}

TEST(gas_balance, what_flows_in_flows_out_or_is_stored_in_every_step) {
  GasInput input = box({6, 4, 16}, Vec3(0.06, 0.04, 0.16), walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 0.8)};
  input.inflows[0].ramp = 0.01;
  input.tolerance = 1e-10;
  GasSolver gas(input, self());
  const double cell = input.grid.cell_volume();
  double before = 0;
  for (int n = 0; n < 20; ++n) {
    const auto eps = [n](int i, int j, int k) {
      return 0.4 + 0.3 * scatter(i, j, k) + 0.2 * std::sin(0.3 * n + 0.5 * k);
    };
    set_bed(
        gas, eps, [](int, int, int) { return 1000.0; }, constant_zero);
    const GasReport report = gas.advance(1e-3);
    double gas_volume = 0;
    for (const double value : gas.void_fraction()) gas_volume += value * cell;
    const double stored = n == 0 ? 0 : input.density * (gas_volume - before) / 1e-3;
    before = gas_volume;
    const double scale = std::max(report.mass_inflow, std::abs(stored));
    // Each of the 384 cells may miss the tolerance.
    EXPECT_NEAR(report.mass_inflow, report.mass_outflow + stored, 384 * 1e-10 * scale) << n;
    EXPECT_LE(report.continuity_residual, 1e-10);
    EXPECT_EQ(report.momentum_not_converged, 0);
  }
}

TEST(gas_balance, the_default_tolerance_keeps_continuity_to_a_millionth_of_the_inflow) {
  GasInput input = box({8, 4, 24}, Vec3(0.04, 0.02, 0.12), walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 1.0)};
  GasSolver gas(input, self());
  set_bed(
      gas, random_void_fraction, [](int i, int j, int k) { return 5e3 * scatter(i, k, j); },
      constant_zero);
  for (int n = 0; n < 5; ++n) EXPECT_LE(gas.advance(1e-3).continuity_residual, 1e-6);
}

TEST(gas_balance, reported_drag_impulse_is_that_of_the_face_velocities) {
  GasInput input = box({5, 4, 10}, Vec3(0.05, 0.04, 0.10), walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 2.0)};
  input.step = 1e-3;
  GasSolver gas(input, self());
  const auto drag = [](int i, int j, int k) { return 2e3 * scatter(i, j, k); };
  const auto source = [](int i, int j, int k) { return 50.0 * scatter(k, j, i) - 20.0; };
  set_bed(gas, random_void_fraction, drag, source);
  gas.advance(2e-3);
  const GasReport report = gas.advance(1e-3);
  ASSERT_EQ(report.substeps, 1);
  // Half of each cell's drag acts on each of its two faces, those on the sides included.
  double force = 0;
  const Array3<double>& w = gas.state().velocity[2];
  const double half = 0.5 * input.grid.cell_volume();
  for_each_cell(gas.domain().faces(2), [&](int i, int j, int k) {
    for (const int cell : {k - 1, k})
      if (cell >= 0 && cell < 10)
        force += half * (drag(i, j, cell) * w(i, j, k) - source(i, j, cell));
  });
  EXPECT_NEAR(report.drag_impulse[2], force * 1e-3, 1e-12 * std::abs(force));
}

TEST(gas_balance, drag_impulse_of_an_interval_is_the_sum_over_its_steps) {
  GasInput input = box({5, 4, 10}, Vec3(0.05, 0.04, 0.10), walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 2.0)};
  const auto drag = [](int i, int j, int k) { return 2e3 * scatter(i, j, k); };
  const auto source = [](int i, int j, int k) { return 50.0 * scatter(k, j, i); };
  input.step = 0.25e-3;
  GasSolver whole(input, self());
  GasSolver parts(input, self());
  set_bed(whole, random_void_fraction, drag, source);
  set_bed(parts, random_void_fraction, drag, source);
  const GasReport report = whole.advance(1e-3);
  EXPECT_EQ(report.substeps, 4);
  Vec3 sum = Vec3::Zero();
  for (int n = 0; n < 4; ++n) sum += parts.advance(0.25e-3).drag_impulse;
  // Exact but for the round-off of the clock (the ramp and dt of the steps).
  EXPECT_LT((report.drag_impulse - sum).norm(), 1e-10 * sum.norm());
}

// With plug flow the balance is -eps dp/dz = K u - S, u = U / eps.
double pressure_drop_per_height(double eps, double drag, double superficial) {
  GasInput input = box({4, 3, 20}, Vec3(0.04, 0.03, 0.2), column);
  input.inflows = {whole_side(input, 4, superficial)};
  input.gravity = Vec3::Zero();
  input.tolerance = 1e-10;
  input.pressure_probes = {0.045, 0.145};
  GasSolver gas(input, self());
  set_bed(
      gas, [=](int, int, int) { return eps; }, [=](int, int, int) { return drag; }, constant_zero);
  GasReport report;
  for (int n = 0; n < 200; ++n) report = gas.advance(1e-3);
  return (report.probe_pressure[0] - report.probe_pressure[1]) / 0.1;
}

TEST(gas_balance, plug_flow_through_uniform_drag_has_the_analytic_pressure_drop) {
  const double eps = 0.4;
  const double drag = 3000;
  const double u = 1.5 / eps;
  EXPECT_NEAR(pressure_drop_per_height(eps, drag, 1.5), drag * u / eps, 1e-6 * drag * u / eps);
}

TEST(gas_balance, ergun_drag_gives_the_ergun_pressure_drop) {
  const double eps = 0.42;
  const double grain = 2.5e-3;
  const double superficial = 1.2;
  const double u = superficial / eps;
  const GasInput air;
  const double mu = air.viscosity;
  const double rho = air.density;
  // Momentum exchange of model A: Hoomans et al. (2001), eq. 27.
  const double beta = 150 * (1 - eps) * (1 - eps) / eps * mu / (grain * grain) +
                      1.75 * (1 - eps) * rho / grain * u * eps / eps;
  const double expected =
      150 * mu * superficial * std::pow(1 - eps, 2) / (std::pow(eps, 3) * grain * grain) +
      1.75 * rho * superficial * superficial * (1 - eps) / (std::pow(eps, 3) * grain);
  EXPECT_NEAR(pressure_drop_per_height(eps, beta, superficial), expected, 1e-6 * expected);
}

TEST(gas_balance, very_stiff_drag_makes_the_gas_follow_the_grains) {
  Sides sides = walls;
  sides[4] = sides[5] = &periodic_side;
  for (int side = 0; side < 4; ++side) sides[side] = &wall_free_slip;
  GasInput input = box({4, 4, 8}, Vec3(0.04, 0.04, 0.08), sides);
  input.gravity = Vec3::Zero();
  GasSolver gas(input, self());
  const double drag = input.density * 0.5 / (1e-6 * input.step);  // relaxes in 1e-6 of a step
  const double grains = 0.7;
  set_bed(
      gas, [](int, int, int) { return 0.5; }, [=](int, int, int) { return drag; },
      [=](int, int, int) { return drag * grains; });
  gas.advance(input.step);
  // One implicit step leaves the ratio of the two times.
  EXPECT_NEAR(gas.mean_velocity()[2](1, 1, 1), grains, 2e-6 * grains);
}

}  // namespace
}  // namespace gasgrain
