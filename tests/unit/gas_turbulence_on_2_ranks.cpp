// Turbulence models split over two ranks against the same run on one.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

GasInput turbulent_spout(const Int3& cells, TurbulenceModel model) {
  GasInput input = endless_spout(cells, 20, 1e-11);
  input.turbulence.model = model;
  return input;
}

class gas_turbulence_split : public testing::TestWithParam<std::tuple<Int3, TurbulenceModel>> {};

TEST_P(gas_turbulence_split, two_ranks_give_what_one_gives) {
  const Communicator world(MPI_COMM_WORLD);
  ASSERT_EQ(world.size(), 2);
  const auto& [cells, model] = GetParam();
  GasSolver one(turbulent_spout(cells, model), self());
  GasSolver two(turbulent_spout(cells, model), world);
  run_spout(one, 0, 4);
  run_spout(two, 0, 4);
  // Both solve to 1e-11 by sweeps in another order; errors add up over grid and steps.
  constexpr double tolerance = 1e-8;
  for (int d = 0; d < 3; ++d)
    for_each_cell(two.own(), [&](int i, int j, int k) {
      ASSERT_NEAR(two.state().velocity[d](i, j, k), one.state().velocity[d](i, j, k),
                  tolerance * 20);
    });
  double worst = 0;
  for_each_cell(two.own().grown(1), [&](int i, int j, int k) {
    if (!one.own().contains(i, j, k)) return;
    const double expected = one.turbulence()->viscosity()(i, j, k);
    const double relative = std::abs(two.turbulence()->viscosity()(i, j, k) / expected - 1);
    worst = std::max(worst, relative);
  });
  EXPECT_LT(worst, tolerance);
  for (int side = 0; side < side_count; ++side) {
    if (!two.domain().touches(side) || !turbulent_spout(cells, model).sides[side]->sticks) continue;
    const Array3<double>& mine = two.turbulence()->wall_coefficient(side);
    const Array3<double>& all = one.turbulence()->wall_coefficient(side);
    for_each_cell(intersection(mine.box(), two.own().grown(1)), [&](int i, int j, int k) {
      if (!all.box().contains(i, j, k)) return;
      ASSERT_NEAR(mine(i, j, k), all(i, j, k), tolerance * all(i, j, k)) << side_names[side];
    });
  }
}

TEST_P(gas_turbulence_split, checkpoint_of_two_ranks_goes_on_bitwise) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string file = testing::TempDir() + "gas_turbulence_split_test.h5";
  const auto& [cells, model] = GetParam();
  GasSolver whole(turbulent_spout(cells, model), world);
  run_spout(whole, 0, 2);
  whole.write_checkpoint(file);
  run_spout(whole, 2, 4);
  GasSolver second(turbulent_spout(cells, model), world);
  second.read_checkpoint(file);
  run_spout(second, 2, 4);
  for (int d = 0; d < 3; ++d)
    EXPECT_TRUE(std::equal(whole.state().velocity[d].begin(), whole.state().velocity[d].end(),
                           second.state().velocity[d].begin()));
  const auto& viscosity = whole.turbulence()->viscosity();
  EXPECT_TRUE(
      std::equal(viscosity.begin(), viscosity.end(), second.turbulence()->viscosity().begin()));
}

// Cut across z, x and y.
INSTANTIATE_TEST_SUITE_P(
    cuts, gas_turbulence_split,
    testing::Combine(testing::Values(Int3{6, 5, 14}, Int3{15, 5, 14}, Int3{6, 15, 14}),
                     testing::Values(TurbulenceModel::smagorinsky, TurbulenceModel::k_epsilon)));

}  // namespace
}  // namespace gasgrain
