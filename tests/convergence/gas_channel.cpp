// Flows between plates whose profile the scheme holds exactly.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr int layers = 16;
constexpr double height = 0.16;

// Flow along `along` between walls across `across`; the third axis has no friction.
GasInput plates(int along, int across) {
  Sides sides;
  sides.fill(&wall_free_slip);
  Int3 cells{1, 1, 1};
  cells[along] = 3;
  cells[across] = layers;
  for (const bool high : {false, true}) {
    sides[side_of(along, high)] = &periodic_side;
    sides[side_of(across, high)] = &wall_no_slip;
  }
  GasInput input = box(cells, 0.01 * Vec3(cells[0], cells[1], cells[2]), sides);
  input.gravity = Vec3::Zero();
  input.viscosity = 0.1;
  input.tolerance = 1e-14;
  input.step = 1e4;  // steady after a few
  input.courant_max = 1e9;
  return input;
}

double velocity(const GasSolver& gas, int along, int across, int layer) {
  Int3 at{0, 0, 0};
  at[across] = layer;
  return gas.state().velocity[along](at[0], at[1], at[2]);
}

double position(int layer) {
  return (layer + 0.5) * height / layers;
}

using Axes = std::pair<int, int>;
class gas_channel : public testing::TestWithParam<Axes> {};

TEST_P(gas_channel, poiseuille_flow_is_exact) {
  const auto [along, across] = GetParam();
  GasInput input = plates(along, across);
  input.gravity[along] = 1.0;  // drives the flow along the periodic axis
  GasSolver gas(input, self());
  for (int n = 0; n < 60; ++n) gas.advance(input.step);
  const double greatest = input.density / (8 * input.viscosity) * height * height;
  for (int n = 0; n < layers; ++n) {
    const double z = position(n);
    const double exact = input.density / (2 * input.viscosity) * z * (height - z);
    EXPECT_NEAR(velocity(gas, along, across, n), exact, 1e-10 * greatest) << n;
  }
}

TEST_P(gas_channel, couette_flow_is_exact) {
  const auto [along, across] = GetParam();
  GasInput input = plates(along, across);
  input.wall_velocity[side_of(across, true)][along] = 2.0;
  input.wall_velocity[side_of(across, false)][along] = -1.0;
  GasSolver gas(input, self());
  for (int n = 0; n < 60; ++n) gas.advance(input.step);
  for (int n = 0; n < layers; ++n)
    EXPECT_NEAR(velocity(gas, along, across, n), -1 + 3 * position(n) / height, 1e-10 * 2) << n;
}

INSTANTIATE_TEST_SUITE_P(axes, gas_channel,
                         testing::Values(Axes{0, 2}, Axes{2, 0}, Axes{0, 1}, Axes{1, 2}));

}  // namespace
}  // namespace gasgrain
