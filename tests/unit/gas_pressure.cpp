// The pressure solvers against each other.
#include <gtest/gtest.h>

#include "coupling/base/error.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

// Velocity along z after some steps in which sources stir the gas.
CellVector stirred(GasInput input, PressureMethod method, int layers_along) {
  input.pressure = method;
  input.tolerance = 1e-11;
  GasSolver gas(input, self());
  const auto layer = [=](int i, int j, int k) { return std::array<int, 3>{i, j, k}[layers_along]; };
  set_bed(
      gas, [=](int i, int j, int k) { return 0.5 + 0.4 * scatter(layer(i, j, k), 0, 0); },
      [=](int i, int j, int k) { return 2e3 * scatter(layer(i, j, k), 1, 0); },
      [](int i, int j, int k) { return 100 * scatter(i, j, k) - 50; });
  for (int n = 0; n < 3; ++n) EXPECT_LE(gas.advance(1e-3).continuity_residual, 1e-10);
  return gas.mean_velocity();
}

void expect_same(const GasInput& input, int layers_along) {
  const CellVector direct = stirred(input, PressureMethod::fftw, layers_along);
  double scale = 0;
  for (int d = 0; d < 3; ++d)
    for (const double u : direct[d]) scale = std::max(scale, std::abs(u));
  // The tolerance 1e-11 is one of the mass flux of a cell; its error adds up over the grid.
  for (const auto method : {PressureMethod::multigrid, PressureMethod::hypre}) {
    const CellVector iterated = stirred(input, method, layers_along);
    for (int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < direct[d].size(); ++n)
        ASSERT_NEAR(direct[d][n], iterated[d][n], 1e-8 * scale);
  }
}

TEST(gas_pressure, solvers_agree_in_layers_below_an_outlet) {
  GasInput input = box({6, 4, 10}, Vec3(0.06, 0.05, 0.1), walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 0.5)};
  expect_same(input, 2);
}

TEST(gas_pressure, solvers_agree_in_layers_along_x_with_outlets_at_both_ends) {
  GasInput input = box({7, 4, 6}, Vec3(0.06, 0.05, 0.1), walls);
  input.sides[0] = input.sides[1] = &outlet;
  expect_same(input, 0);
}

TEST(gas_pressure, solvers_agree_with_periodic_axes_of_any_length) {
  for (const Int3& cells : {Int3{8, 4, 8}, Int3{6, 5, 9}, Int3{12, 1, 10}, Int3{6, 2, 7}}) {
    GasInput input = box(cells, Vec3(0.06, 0.05, 0.1), walls);
    input.sides[0] = input.sides[1] = &periodic_side;
    input.sides[2] = input.sides[3] = &periodic_side;
    input.sides[5] = &outlet;
    SCOPED_TRACE(fmt::format("{} x {} x {}", cells[0], cells[1], cells[2]));
    expect_same(input, 2);
  }
}

TEST(gas_pressure, solvers_agree_in_a_box_that_is_periodic_in_all_directions) {
  Sides sides;
  sides.fill(&periodic_side);
  expect_same(box({6, 4, 8}, Vec3(0.06, 0.05, 0.1), sides), 2);
}

TEST(gas_pressure, solvers_agree_in_a_sealed_box) {
  expect_same(box({6, 4, 8}, Vec3(0.06, 0.05, 0.1), walls), 2);
}

TEST(gas_pressure, fftw_says_what_it_cannot_solve) {
  GasInput input = box({6, 4, 8}, Vec3(0.06, 0.05, 0.1), column);
  input.sides[1] = &outlet;
  input.pressure = PressureMethod::fftw;
  GasSolver gas(input, self());
  set_bed(
      gas, [](int i, int j, int k) { return 0.5 + 0.4 * scatter(i, j, k); }, constant_zero,
      constant_zero);
  try {
    gas.advance(1e-3);
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("sides of more than one axis"), std::string::npos)
        << e.what();
  }
}

TEST(gas_pressure, auto_iterates_where_outlets_lie_on_more_than_one_axis) {
  GasInput input = box({6, 4, 8}, Vec3(0.06, 0.05, 0.1), column);
  input.sides[1] = &outlet;
  input.inflows = {whole_side(input, 4, 0.5)};
  GasSolver gas(input, self());
  for (int n = 0; n < 3; ++n) EXPECT_LE(gas.advance(1e-3).continuity_residual, input.tolerance);
}

TEST(gas_pressure, auto_solves_empty_gas_directly_and_iterates_in_a_bed) {
  GasInput input = box({6, 4, 8}, Vec3(0.06, 0.05, 0.1), column);
  input.inflows = {whole_side(input, 4, 0.5)};
  InflowPatch& patch = input.inflows[0];
  patch.outline.bounds.hi[0] = 0.03;
  GasSolver gas(input, self());
  EXPECT_EQ(gas.advance(1e-3).pressure_iterations, 0);
  set_bed(
      gas, [](int i, int j, int k) { return 0.5 + 0.4 * scatter(i, j, k); }, constant_zero,
      constant_zero);
  EXPECT_GT(gas.advance(1e-3).pressure_iterations, 0);
}

}  // namespace
}  // namespace gasgrain
