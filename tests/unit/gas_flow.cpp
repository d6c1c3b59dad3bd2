// Flows with known answers, and what boundaries do.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

void set_dense_bed(GasSolver& gas) {
  set_bed(
      gas, [](int, int, int k) { return k < 25 ? 0.42 : 1.0; },
      [](int, int, int k) { return k < 25 ? 5000.0 : 0.0; }, constant_zero);
}

TEST(gas_flow, uniform_flow_stays_uniform_while_the_void_fraction_changes_around_it) {
  Sides sides;
  sides.fill(&periodic_side);
  GasInput input = box({8, 6, 4}, Vec3(0.08, 0.06, 0.04), sides);
  input.gravity = Vec3::Zero();
  input.viscosity = 0;
  input.tolerance = 1e-13;
  const double u = 3.0;
  input.step = 1e-3;
  GasSolver gas(input, self());
  gas.state().velocity[0].fill(u);
  // Void fractions that u carries along, from the last one back: each step obeys the discrete
  // continuity equation, whose fluxes take the void fraction at the step's end.
  std::vector<std::array<double, 8>> eps(11);
  for (int i = 0; i < 8; ++i) eps[10][i] = 0.6 + 0.2 * std::sin(2 * M_PI * i / 8.0);
  for (int n = 10; n > 0; --n)
    for (int i = 0; i < 8; ++i)
      eps[n - 1][i] =
          eps[n][i] + u * input.step / 0.01 * 0.5 * (eps[n][(i + 1) % 8] - eps[n][(i + 7) % 8]);
  for (int n = 0; n <= 10; ++n) {
    set_bed(
        gas, [&](int i, int, int) { return eps[n][i]; }, constant_zero, constant_zero);
    if (n > 0) gas.advance(input.step);
  }
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(gas.state().velocity[0](i, 2, 1), u, 1e-12 * u);
  EXPECT_LT(std::abs(gas.state().pressure(3, 3, 3)), 1e-9);
}

TEST(gas_flow, nozzle_smaller_than_a_cell_brings_its_mass_exactly_and_its_momentum) {
  GasInput input = box({9, 9, 30}, Vec3(0.09, 0.09, 0.3), column);
  input.gravity = Vec3::Zero();
  input.viscosity = 0;
  const double mass_flow = 2e-4;
  const Outline circle{{{0.0425, 0.0425}, {0.0475, 0.0475}}, true};
  const InflowPatch nozzle = jet_through(circle, mass_flow / (input.density * circle.area()));
  input.inflows = {nozzle};
  input.convection = Convection::upwind;
  input.courant_max = 1000;
  GasSolver gas(input, self());
  GasReport report;
  for (int n = 0; n < 400; ++n) report = gas.advance(1e-3);
  EXPECT_NEAR(report.mass_inflow, mass_flow, 1e-12 * mass_flow);
  // What leaves the control volumes of the first faces above the floor, once the flow is steady: by
  // convection up and down, and against the pressure.
  const auto& flux = gas.state().mass_flux[2];
  const auto& w = gas.state().velocity[2];
  const auto& p = gas.state().pressure;
  const auto carried = [](double f, double below, double above) {
    return f > 0 ? f * below : f * above;
  };
  double momentum = 0;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) {
      momentum += carried(0.5 * (flux(i, j, 1) + flux(i, j, 2)), w(i, j, 1), w(i, j, 2));
      momentum -= carried(0.5 * (flux(i, j, 0) + flux(i, j, 1)), 0.0, w(i, j, 1));
      momentum += p(i, j, 1) - p(i, j, 0);
    }
  momentum *= 0.01 * 0.01;
  const double expected = mass_flow * nozzle.velocity;
  // Steady to this share after 0.4 s.
  EXPECT_NEAR(momentum, expected, 1e-4 * expected);
}

TEST(gas_flow, backflow_through_an_outlet_stays_bounded_and_is_counted) {
  GasInput input = box({8, 2, 12}, Vec3(0.08, 0.02, 0.12), walls);
  input.sides[5] = &outlet;
  // Entrains gas through the top.
  input.inflows = {jet_through({{{0.03, 0.0}, {0.05, 0.02}}, false}, 60)};
  GasSolver gas(input, self());
  long backflow = 0;
  for (int n = 0; n < 200; ++n) {
    const GasReport report = gas.advance(1e-3);
    backflow = std::max(backflow, report.backflow_faces);
    ASSERT_NEAR(report.mass_inflow, report.mass_outflow, 1e-4 * report.mass_inflow);
  }
  EXPECT_GT(backflow, 0);
  EXPECT_LT(greatest_speed(gas), 120);
}

TEST(gas_flow, gas_drawn_in_through_an_outlet_stays_bounded) {
  // A column whose grains sink sucks gas in from above; then the drag pulls gas down and out again.
  GasInput input = box({4, 4, 12}, Vec3(0.04, 0.04, 0.12), walls);
  input.sides[5] = &outlet;
  GasSolver gas(input, self());
  for (int n = 0; n < 100; ++n) {
    const double eps = 0.6 + 0.3 * std::sin(0.2 * n);
    set_bed(
        gas, [=](int, int, int k) { return k < 8 ? eps : 1.0; }, constant_zero, constant_zero);
    gas.advance(1e-3);
    ASSERT_LT(greatest_speed(gas), 30) << n;
  }
}

TEST(gas_flow, sealed_box_runs_and_reports_what_cannot_be_met) {
  GasInput input = box({6, 6, 6}, Vec3(0.06, 0.06, 0.06), walls);
  GasSolver gas(input, self());
  const auto eps = [](double shift) {
    return [shift](int i, int j, int k) { return 0.5 + 0.2 * scatter(i, j, k) + shift; };
  };
  const auto force = [](int i, int, int) { return i < 3 ? 5.0 : -5.0; };
  set_bed(
      gas, eps(0), [](int, int, int) { return 100.0; }, force);
  EXPECT_LE(gas.advance(1e-3).continuity_residual, 1e-6);
  EXPECT_GT(greatest_speed(gas), 1e-4);
  // Grains that swell have no gas to push out: the mean of d eps/dt is left over, and said.
  set_bed(
      gas, eps(-0.01), [](int, int, int) { return 100.0; }, force);
  EXPECT_GT(gas.advance(1e-3).continuity_residual, 1e-6);
}

TEST(gas_flow, thin_jet_at_a_high_courant_number_stays_bounded) {
  GasInput input = thin_jet();
  input.step = 0.5e-3;
  for (const bool with_bed : {true, false}) {
    GasSolver gas(input, self());
    if (with_bed) set_dense_bed(gas);
    double courant = 0;
    double greatest = 0;
    for (int n = 0; n < 100; ++n) {
      courant = std::max(courant, gas.advance(0.5e-3).courant_max);
      greatest = std::max(greatest, greatest_speed(gas));
    }
    EXPECT_GT(courant, 15);
    // A jet of one whole cell may speed up a little: grains narrow its way, the pressure drives it.
    EXPECT_LT(greatest, 1.25 * input.inflows[0].velocity) << (with_bed ? "bed" : "free");
  }
}

TEST(gas_flow, thin_jet_stays_bounded_with_crank_nicolson_at_its_courant_number) {
  GasInput input = thin_jet();
  input.scheme = TimeScheme::crank_nicolson;
  input.courant_max = 2;
  for (const bool with_bed : {true, false}) {
    GasSolver gas(input, self());
    if (with_bed) set_dense_bed(gas);
    double greatest = 0;
    for (int n = 0; n < 20; ++n) {
      gas.advance(0.5e-3);
      greatest = std::max(greatest, greatest_speed(gas));
    }
    EXPECT_LT(greatest, 1.25 * input.inflows[0].velocity) << (with_bed ? "bed" : "free");
  }
}

TEST(gas_flow, jet_that_starts_in_gas_at_rest_is_no_faster_than_its_nozzle_at_any_step) {
  GasInput input = box({36, 6, 30}, Vec3(0.15, 0.02, 0.14), walls);
  input.sides[5] = &outlet;
  const InflowPatch nozzle = jet_through({{{0.0725, 0.0075}, {0.0775, 0.0125}}, true}, 180);
  input.inflows = {nozzle};
  input.courant_max = 1000;
  for (const double step : {0.25e-3, 1e-3, 4e-3}) {
    input.step = step;
    GasSolver gas(input, self());
    for (int n = 0; n < 20; ++n) {
      gas.advance(step);
      ASSERT_LT(greatest_speed(gas), nozzle.velocity) << step << " s, step " << n;
    }
  }
}

TEST(gas_flow, courant_number_limits_the_step_and_the_steps_fill_the_interval) {
  GasInput input = box({4, 4, 12}, Vec3(0.04, 0.04, 0.12), column);
  input.inflows = {whole_side(input, 4, 10.0)};
  input.courant_max = 2;
  input.step = 1;
  GasSolver gas(input, self());
  gas.advance(0.05);
  const GasReport report = gas.advance(0.0101);
  EXPECT_EQ(report.substeps, 6);  // 2 h / u = 2 ms
  EXPECT_NEAR(report.step, 0.0101 / 6, 1e-9);
  EXPECT_LE(report.courant_max, 2.0);
  EXPECT_NEAR(report.time, 0.0601, 1e-12);
}

TEST(gas_flow, velocity_that_is_not_finite_names_the_cell) {
  // With every solver of the pressure: in uniform gas FFTW solves directly, in a bed all iterate.
  for (const PressureMethod method : {PressureMethod::automatic, PressureMethod::multigrid,
                                      PressureMethod::fftw, PressureMethod::hypre})
    for (const bool bed : {false, true}) {
      GasInput input = box({4, 4, 4}, Vec3(0.04, 0.04, 0.04), column);
      input.pressure = method;
      GasSolver gas(input, self());
      set_bed(
          gas, [=](int i, int j, int k) { return bed ? 0.4 + 0.5 * scatter(i, j, k) : 0.5; },
          [](int, int, int) { return 1.0; }, [](int, int, int) { return std::nan(""); });
      try {
        gas.advance(1e-3);
        FAIL() << "no error";
      } catch (const std::exception& e) {
        EXPECT_NE(std::string(e.what()).find("not finite at t = 0.001 s"), std::string::npos)
            << e.what();
        EXPECT_NE(std::string(e.what()).find("cell ("), std::string::npos);
      }
    }
}

}  // namespace
}  // namespace gasgrain
