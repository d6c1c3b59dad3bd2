// Balances of the gas solver: rest, mass, drag impulse, pressure drop.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

double random_void_fraction(int i, int j, int k) {
  return 0.35 + 0.65 * scatter(i, j, k);
}

void expect_rest(GasInput input) {
  input.gravity = Vec3(1.0, -2.0, -9.81);
  GasSolver gas(input, self());
  const double per_share = input.model == GasModel::a ? 1.0 : 0.5;  // any drag will do
  set_bed(
      gas, random_void_fraction,
      [=](int i, int j, int k) { return 1e4 * per_share * scatter(k, i, j); }, constant_zero);
  for (int n = 0; n < 100; ++n) gas.advance(1e-3);
  // The hydrostatic pressure is kept apart, so that nothing is left to round off.
  EXPECT_LT(greatest_speed(gas), 1e-10);
  // Weight of the gas, that of an ideal one within its growth over the box.
  EXPECT_NEAR(gas.mean_pressure_gradient()[2](3, 2, 5), -9.81 * input.density,
              input.law == GasLaw::ideal_gas ? 1e-3 : 1e-10);
}

TEST(gas_balance, gas_at_rest_under_gravity_stays_at_rest_in_any_void_fraction) {
  for (const int outlet_side : {5, 0, -1}) {
    Sides sides = walls;
    if (outlet_side >= 0) sides[outlet_side] = &outlet;
    GasInput input = box({6, 5, 12}, Vec3(0.06, 0.05, 0.12), sides);
    expect_rest(input);
    input.model = GasModel::b;
    expect_rest(input);
    input.scheme = TimeScheme::crank_nicolson;
    input.pressure_velocity = PressureVelocity::simplec;
    expect_rest(input);
  }
}

TEST(gas_balance, ideal_gas_at_rest_under_gravity_stays_at_rest_in_any_void_fraction) {
  for (const int outlet_side : {5, 0, -1}) {
    Sides sides = walls;
    if (outlet_side >= 0) sides[outlet_side] = &outlet;
    GasInput input = ideal_gas(box({6, 5, 12}, Vec3(0.06, 0.05, 0.12), sides));
    expect_rest(input);
    input.model = GasModel::b;
    expect_rest(input);
  }
}

// Mass of the gas in the grid [kg].
double mass(const GasSolver& gas, const GasInput& input) {
  double sum = 0;
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    const double rho =
        gas.state().density.size() > 0 ? gas.state().density(i, j, k) : input.density;
    sum += rho * gas.state().void_fraction(i, j, k);
  });
  return sum * gas.grid().cell_volume();
}

void expect_mass_balance(GasInput input) {
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 0.8)};
  input.inflows[0].ramp = 0.01;
  input.mass_sources = {{Vec3(0, 0, 0.1), Vec3(0.03, 0.04, 0.13), 1e-4}};
  GasSolver gas(input, self());
  double before = 0;
  for (int n = 0; n < 20; ++n) {
    const auto eps = [n](int i, int j, int k) {
      return 0.4 + 0.3 * scatter(i, j, k) + 0.2 * std::sin(0.3 * n + 0.5 * k);
    };
    set_bed(
        gas, eps, [](int, int, int) { return 1000.0; }, constant_zero);
    const GasReport report = gas.advance(1e-3);
    const double now = mass(gas, input);
    const double stored = n == 0 ? 0 : (now - before) / 1e-3;
    before = now;
    // At the default tolerance: what a cell lacks is made up for by the whole.
    const double scale = std::max(report.mass_inflow, std::abs(stored));
    if (n > 0) {
      EXPECT_NEAR(report.mass_inflow + 1e-4, report.mass_outflow + stored, 1e-10 * scale) << n;
    }
    EXPECT_LE(report.mass_imbalance, 1e-10);
    EXPECT_LE(report.continuity_residual, input.tolerance);
    EXPECT_EQ(report.momentum_not_converged, 0);
    EXPECT_EQ(report.outer_not_converged, 0);
  }
}

TEST(gas_balance, what_flows_in_flows_out_or_is_stored_in_every_step) {
  GasInput input = box({6, 4, 16}, Vec3(0.06, 0.04, 0.16), walls);
  expect_mass_balance(input);
  input.scheme = TimeScheme::crank_nicolson;
  expect_mass_balance(input);
  input = ideal_gas(input);
  input.scheme = TimeScheme::implicit_euler;
  expect_mass_balance(input);
  input.pressure_velocity = PressureVelocity::simplec;
  input.relax_velocity = 0.9;
  input.relax_pressure = 1.0;
  expect_mass_balance(input);
}

TEST(gas_balance, sealed_box_of_ideal_gas_is_pressurised_as_the_gas_law_says) {
  GasInput input = ideal_gas(box({5, 4, 6}, Vec3(0.05, 0.04, 0.06), walls));
  input.gravity = Vec3::Zero();
  InflowPatch nozzle;
  nozzle.side = 4;
  nozzle.outline = {{{0.02, 0.01}, {0.03, 0.03}}, false};
  nozzle.mass_flow = 2e-5;
  input.inflows = {nozzle};
  GasSolver gas(input, self());
  const double eps = 0.6;
  set_bed(
      gas, [=](int, int, int) { return eps; }, constant_zero, constant_zero);
  const int steps = 50;
  for (int n = 0; n < steps; ++n) {
    const GasReport report = gas.advance(1e-3);
    EXPECT_NEAR(report.mass_inflow, nozzle.mass_flow, 1e-12 * nozzle.mass_flow);
  }
  double pressure = 0;
  for (const double p : gas.pressure()) pressure += p;
  pressure /= static_cast<double>(gas.own().size());
  const double volume = eps * 0.05 * 0.04 * 0.06;
  const double expected = nozzle.mass_flow * steps * 1e-3 * gas_constant * input.temperature /
                          (volume * input.molar_mass);
  EXPECT_GT(expected, 1000);
  EXPECT_NEAR(pressure, expected, 1e-9 * expected);
}

TEST(gas_balance, ideal_gas_carries_sound_at_its_isothermal_speed) {
  // A standing wave between walls, half a wave long, which an implicit step of 1/400 of a period
  // damps but hardly slows.
  Sides sides = walls;
  for (const int side : {0, 1, 2, 3}) sides[side] = &wall_free_slip;
  GasInput input = ideal_gas(box({1, 1, 64}, Vec3(0.01, 0.01, 1), sides));
  input.gravity = Vec3::Zero();
  input.scheme = TimeScheme::crank_nicolson;
  const double speed = std::sqrt(gas_constant * input.temperature / input.molar_mass);
  const double period = 2.0 / speed;
  input.step = period / 400;
  input.tolerance = 1e-10;
  GasSolver gas(input, self());
  const double amplitude = 1e-3;
  for_each_cell(gas.domain().inner_faces(2), [&](int i, int j, int k) {
    gas.state().velocity[2](i, j, k) = amplitude * std::sin(M_PI * k / 64.0);
  });
  double last = amplitude;
  double crossing = 0;  // of the velocity in the middle through 0, a quarter of a period
  for (int n = 1; n <= 200 && crossing == 0; ++n) {
    gas.advance(input.step);
    const double now = gas.state().velocity[2](0, 0, 32);
    if (now <= 0) crossing = (n - 1 + last / (last - now)) * input.step;
    last = now;
  }
  EXPECT_NEAR(crossing, period / 4, 0.01 * period / 4);
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

TEST(gas_balance, drag_impulse_is_what_uniform_gas_loses_with_every_time_scheme) {
  Sides sides;
  sides.fill(&periodic_side);
  for (const TimeScheme scheme : {TimeScheme::implicit_euler, TimeScheme::crank_nicolson}) {
    GasInput input = box({4, 3, 5}, Vec3(0.04, 0.03, 0.05), sides);
    input.gravity = Vec3::Zero();
    input.scheme = scheme;
    input.tolerance = 1e-13;
    const double eps = 0.5;
    const double drag = 900;  // relaxes in 0.7 of a step
    GasSolver gas(input, self());
    gas.state().velocity[2].fill(2.0);
    set_bed(
        gas, [=](int, int, int) { return eps; }, [=](int, int, int) { return drag; },
        [=](int, int, int) { return 0.3 * drag; });
    const double before = 2.0;
    const GasReport report = gas.advance(input.step);
    const double after = gas.state().velocity[2](1, 1, 1);
    const double volume = 0.04 * 0.03 * 0.05;
    // Sweeps round a periodic axis end at 1e-13 by their own estimate.
    EXPECT_NEAR(report.drag_impulse[2], input.density * eps * volume * (before - after),
                1e-10 * input.density * volume);
    const double share = scheme == TimeScheme::crank_nicolson ? 0.5 : 1.0;
    const double at = share * after + (1 - share) * before;
    EXPECT_NEAR(input.density * eps * (after - before) / input.step, -drag * (at - 0.3),
                1e-9 * drag);
  }
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
