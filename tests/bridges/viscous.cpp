// Viscous coefficients against lubrication theory, and their limits.
#include "fix_cfd_coupling/dem_physics/bridge/viscous.h"

#include <gtest/gtest.h>

#include "tests/bridges/bridge_cases.h"

namespace gasgrain::bridge::test {
namespace {

constexpr double mu = 1e-3, roughness = 1e-6;

// Squeezing: Reynolds' pressure p(r) = 3 mu R v / (2 H^2), H = s + r^2 / R the film between two
// spheres of radius R, integrated over the whole film; from the contact of a bridge so wide that
// X = 1 the same.
TEST(Viscous, normal_is_the_integral_of_reynolds_pressure_in_a_wide_bridge) {
  const double r = 0.5e-3, s = 1e-6;
  // H = s + 2 r^2 / (2 R); dp/dr = -6 mu v r / H^3 -> p = 3 mu v R / (2 H^2)
  double force = 0.0;
  const int n = 200000;
  const double wide = 300.0 * std::sqrt(r * s);
  for (int k = 0; k < n; ++k) {
    const double x = (k + 0.5) * wide / n, film = s + x * x / r;
    force += 1.5 * mu * r / (film * film) * 2.0 * pi * x * wide / n;
  }
  LiquidBridge b = equal_grains(1.0, 0.0);
  b.volume *= 1e6;  // X = 1 - 2e-6
  EXPECT_NEAR(viscous_normal(b, mu, s, roughness) / force, 1.0, 1e-4);
}

TEST(Viscous, normal_of_a_finite_bridge_has_its_published_factor) {
  for_each_bridge([](const LiquidBridge& b) {
    for (const double s : {2e-6, 1e-5, 3e-5}) {
      const double x = 1.0 - 1.0 / std::sqrt(1.0 + 2.0 * b.volume / (pi * b.radius * s * s));
      const double reduced = 0.5 * b.radius;
      EXPECT_NEAR(
          viscous_normal(b, mu, s, roughness) / (6.0 * pi * mu * reduced * reduced / s * x * x),
          1.0, 1e-8);
    }
  });
}

// Goldman, Cox and Brenner's exact solution of a sphere that slides along a wall: at s / r =
// 0.003202 it resists 4.0223, at 0.005004 3.7863, at 0.0453 2.6475 times Stokes' drag. The law
// leaves out terms of the order (s / r) ln(s / r).
TEST(Viscous, tangential_near_a_wall_is_that_of_the_exact_solution) {
  const LiquidBridge b = grain_on_wall(1e-2, 0.0);
  const double r = 0.5 * b.radius;
  for (const auto& [s, exact] : {std::pair{0.003202, 4.0223}, {0.005004, 3.7863}, {0.0453, 2.6475}})
    EXPECT_NEAR(viscous_tangential(b, mu, s * r, 1e-9) / (6.0 * pi * mu * r), exact, 0.02 * exact);
}

TEST(Viscous, below_the_minimum_separation_nothing_grows) {
  const LiquidBridge b = equal_grains(1e-2, 0.0);
  for (const double gap : {-1e-4, 0.0, 1e-9, roughness}) {
    EXPECT_EQ(viscous_normal(b, mu, gap, roughness), viscous_normal(b, mu, roughness, roughness));
    EXPECT_EQ(viscous_tangential(b, mu, gap, roughness),
              viscous_tangential(b, mu, roughness, roughness));
  }
  EXPECT_GT(viscous_normal(b, mu, 0.0, 0.1 * roughness), viscous_normal(b, mu, 0.0, roughness));
  EXPECT_GT(viscous_tangential(b, mu, 0.0, 0.1 * roughness),
            viscous_tangential(b, mu, 0.0, roughness));
}

TEST(Viscous, resists_and_never_drives) {
  for_each_bridge([](const LiquidBridge& b) {
    for (const double gap : {0.0, 1e-6, 1e-4, 1e-2, 1.0}) {
      EXPECT_GE(viscous_normal(b, mu, gap, roughness), 0.0);
      EXPECT_GE(viscous_tangential(b, mu, gap, roughness), 0.0);
    }
  });
}

TEST(Viscous, without_liquid_there_is_none) {
  const LiquidBridge b = equal_grains(0.0, 0.0);
  EXPECT_EQ(viscous_normal(b, mu, 0.0, roughness), 0.0);
  EXPECT_EQ(viscous_tangential(b, mu, 0.0, roughness), 0.0);
}

// A little liquid resists a little: the coefficient has no step at zero volume.
TEST(Viscous, normal_goes_to_zero_with_the_volume) {
  double before = viscous_normal(equal_grains(1e-6, 0.0), mu, roughness, roughness);
  for (const double v : {1e-8, 1e-10, 1e-12}) {
    const double now = viscous_normal(equal_grains(v, 0.0), mu, roughness, roughness);
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_LT(before, 1e-6 * viscous_normal(equal_grains(1e-2, 0.0), mu, roughness, roughness));
}

}  // namespace
}  // namespace gasgrain::bridge::test
