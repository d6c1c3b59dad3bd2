// Grains that fall in a sealed box of gas of constant density: what they displace has no way out,
// so that solids that are lost on the way to the gas leave a flow that no velocity can bring to
// balance.
#include <gtest/gtest.h>

#include "tests/stability/coupled_bed.h"

namespace gasgrain::stability {
namespace {

constexpr double diameter = 1e-3;

GasInput sealed() {
  GasInput input = gas_cases::box({6, 6, 12}, Vec3(6, 6, 12) * 1.5 * diameter, gas_cases::walls);
  input.tolerance = 1e-10;
  return input;
}

// In the upper half; scattered so that cells differ.
Cloud scattered(const GasInput& input) {
  Random random(4);
  Cloud cloud;
  const int along = 9;
  const Vec3 h = Vec3(input.grid.hi[0], input.grid.hi[1], 0.5 * input.grid.hi[2]) / along;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < along; ++j)
      for (int k = 0; k < along; ++k)
        cloud.add(Vec3(0, 0, 0.45 * input.grid.hi[2]) +
                      h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5)) +
                      random.vector(0.4 * diameter),
                  Vec3::Zero(), 0.5 * diameter, 2500 * sphere_volume(0.5 * diameter));
  return cloud;
}

TEST(sealed_box, keeps_continuity_which_solids_that_are_cut_off_break) {
  const GasInput input = sealed();
  Pace pace;
  pace.interval = 1e-3;
  pace.steps = 20;
  CoupledBed bed(input, "drag koch_hill pressure_gradient void_fraction trilinear", pace,
                 scattered(input));
  bed.weight = Vec3(0, 0, -9.81);
  GasSolver naive(input, self());
  double worst_naive = 0.0;
  double energy = 0.0;
  double heights = 0.0;
  for (std::size_t p = 0; p < bed.cloud.radius.size(); ++p)
    heights += bed.cloud.mass[p] * 9.81 * bed.cloud.view().x(p)[2];
  for (int n = 0; n < 30; ++n) {
    bed.advance();
    EXPECT_LT(bed.report().continuity_residual, 1e-8) << n;
    EXPECT_LT(bed.report().mass_imbalance, 1e-10) << n;
    EXPECT_EQ(bed.report().backflow_faces, 0);
    EXPECT_LT(gas_cases::greatest_speed(bed.gas()), 3.0) << n;
    double now = 0.0;
    for (std::size_t p = 0; p < bed.cloud.radius.size(); ++p)
      now += bed.cloud.mass[p] * 9.81 * bed.cloud.view().x(p)[2];
    energy = bed.grain_energy() + now;
    EXPECT_LT(energy, heights * (1 + 1e-9)) << n;

    // The same bed, what of it is denser than 0.4 cut off.
    Array3<double> eps = bed.gas().void_fraction();
    for (double& value : eps) value = std::max(value, 0.6);
    naive.set_void_fraction(eps);
    worst_naive = std::max(worst_naive, naive.advance(1e-3).continuity_residual);
  }
  EXPECT_LT(bed.ledger().residual(), 1e-12);
  std::printf("continuity: %.2g, with solids cut off %.2g; energy left %.4f\n",
              bed.report().continuity_residual, worst_naive, energy / heights);
  EXPECT_GT(worst_naive, 1e-4);
}

}  // namespace
}  // namespace gasgrain::stability
