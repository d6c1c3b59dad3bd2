// Height of the bed, size of its bubbles, pressure probes.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

TEST(gas_measures, bubble_and_surface_of_a_drawn_bed) {
  GasInput input = box({10, 3, 20}, Vec3(0.1, 0.03, 0.2), walls);
  input.sides[5] = &outlet;
  GasSolver gas(input, self());
  // A bed 12 cells high, a hump of 2 more in one column, a bubble of 3 x 4 cells through the depth,
  // and one that spans a third of it, which the mean over the depth does not count.
  const auto eps = [](int i, int j, int k) {
    if (i >= 3 && i < 6 && k >= 4 && k < 8) return 0.95;
    if (i == 8 && k == 5 && j == 0) return 1.0;
    return k < (i == 7 ? 14 : 12) ? 0.42 : 1.0;
  };
  set_bed(gas, eps, constant_zero, constant_zero);
  const GasReport report = gas.advance(1e-3);
  EXPECT_NEAR(report.surface_height, 0.14, 1e-12);
  EXPECT_NEAR(report.bubble_diameter, std::sqrt(4 * 12 * 1e-4 / M_PI), 1e-12);
}

TEST(gas_measures, empty_grid_has_no_bed) {
  GasInput input = box({4, 4, 4}, Vec3(0.04, 0.04, 0.04), column);
  GasSolver gas(input, self());
  const GasReport report = gas.advance(1e-3);
  EXPECT_EQ(report.surface_height, 0.0);
  EXPECT_EQ(report.bubble_diameter, 0.0);
}

TEST(gas_measures, probe_in_gas_at_rest_reads_the_weight_above_it) {
  GasInput input = box({4, 4, 10}, Vec3(0.04, 0.04, 0.1), column);
  input.outlet_pressure = 101325;
  input.pressure_probes = {0.025};
  GasSolver gas(input, self());
  EXPECT_NEAR(gas.advance(1e-3).probe_pressure[0], 1.2 * 9.81 * 0.075, 1e-9);
}

}  // namespace
}  // namespace gasgrain
