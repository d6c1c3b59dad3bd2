// A run split over two ranks against the same run on one.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

GasInput probed_spout(const Int3& cells) {
  GasInput input = endless_spout(cells, 20, 1e-11);
  input.pressure_probes = {0.03, 0.1};
  return input;
}

class gas_split : public testing::TestWithParam<Int3> {};

TEST_P(gas_split, two_ranks_give_what_one_gives) {
  const Communicator world(MPI_COMM_WORLD);
  ASSERT_EQ(world.size(), 2);
  const GasInput input = probed_spout(GetParam());
  GasSolver one(input, self());
  GasSolver two(input, world);
  for (GasSolver* gas : {&one, &two}) gas->ask_for({true, true, true});
  const GasReport r1 = run_spout(one, 0, 4);
  const GasReport r2 = run_spout(two, 0, 4);
  // Both solve to 1e-11 of the inflow a cell, by different ways; errors add up over grid and steps.
  constexpr double tolerance = 1e-7;
  for (int d = 0; d < 3; ++d)
    for_each_cell(two.own(), [&](int i, int j, int k) {
      ASSERT_NEAR(two.mean_velocity()[d](i, j, k), one.mean_velocity()[d](i, j, k), tolerance * 20);
      ASSERT_NEAR(two.mean_pressure_gradient()[d](i, j, k),
                  one.mean_pressure_gradient()[d](i, j, k), tolerance * 1e5);
      // With cells of 1 cm: u / h, u^2 / h and u / (1 ms), mu u / h^2.
      ASSERT_NEAR(two.mean_vorticity()[d](i, j, k), one.mean_vorticity()[d](i, j, k),
                  tolerance * 2e3);
      ASSERT_NEAR(two.mean_acceleration()[d](i, j, k), one.mean_acceleration()[d](i, j, k),
                  tolerance * 4e4);
      ASSERT_NEAR(two.mean_viscous_force()[d](i, j, k), one.mean_viscous_force()[d](i, j, k),
                  tolerance * input.viscosity * 2e5);
    });
  EXPECT_EQ(r1.surface_height, r2.surface_height);
  EXPECT_EQ(r1.bubble_diameter, r2.bubble_diameter);
  EXPECT_NEAR(r1.mass_outflow, r2.mass_outflow, 1e-8 * r1.mass_outflow);
  EXPECT_LT((r1.drag_impulse - r2.drag_impulse).norm(), 1e-7 * r1.drag_impulse.norm());
  for (int n = 0; n < 2; ++n)
    EXPECT_NEAR(r1.probe_pressure[n], r2.probe_pressure[n], 1e-6 * std::abs(r1.probe_pressure[n]));
}

TEST_P(gas_split, checkpoint_of_two_ranks_goes_on_bitwise) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string file = testing::TempDir() + "gas_split_test.h5";
  const GasInput input = probed_spout(GetParam());
  GasSolver whole(input, world);
  run_spout(whole, 0, 2);
  whole.write_checkpoint(file);
  run_spout(whole, 2, 4);
  GasSolver second(input, world);
  second.read_checkpoint(file);
  run_spout(second, 2, 4);
  for (int d = 0; d < 3; ++d)
    EXPECT_TRUE(std::equal(whole.state().velocity[d].begin(), whole.state().velocity[d].end(),
                           second.state().velocity[d].begin()));
  EXPECT_TRUE(std::equal(whole.state().pressure.begin(), whole.state().pressure.end(),
                         second.state().pressure.begin()));
}

// Cut across z, x and y.
INSTANTIATE_TEST_SUITE_P(cuts, gas_split,
                         testing::Values(Int3{6, 5, 14}, Int3{15, 5, 14}, Int3{6, 15, 14}));

}  // namespace
}  // namespace gasgrain
