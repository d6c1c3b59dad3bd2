// Where the liquid of a broken bridge goes: all of it, and as each rule has it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "coupling/base/choice_list.h"
#include "fix_cfd_coupling/dem_physics/liquid/divisions.h"

namespace gasgrain::liquid {
namespace {

constexpr double wall = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;
constexpr double right_angle = 0.5 * pi;

template <class F>
void for_each_broken(const F& f) {
  for (const double volume : {1e-24, 1e-18, 1e-13, 3.3e-11})
    for (const double r_j : {1e-3, 15e-3, wall})
      for (const double angle_i : {0.0, 0.3, 1.1, right_angle})
        for (const double angle_j : {0.0, 0.3, 0.9, right_angle})
          for (const double share : {0.0, 0.37, 1.0})
            f(BrokenBridge{
                volume, {1e-3, angle_i, share * volume}, {r_j, angle_j, (1.0 - share) * volume}});
}

TEST(LiquidDivision, conserves_the_volume_and_gives_no_side_less_than_nothing) {
  for_each_choice<DivisionRule>([](auto rule) {
    for_each_broken([&](const BrokenBridge& b) {
      const Division d = rule.divide(b);
      EXPECT_GE(d.to_i, 0.0) << rule.name;
      EXPECT_GE(d.to_j, 0.0) << rule.name;
      EXPECT_NEAR((d.to_i + d.to_j) / b.volume, 1.0, 2.3e-16) << rule.name;  // one rounding
    });
  });
}

TEST(LiquidDivision, exchanged_partners_exchange_their_liquid) {
  for_each_choice<DivisionRule>([](auto rule) {
    for_each_broken([&](const BrokenBridge& b) {
      const Division d = rule.divide(b), swapped = rule.divide({b.volume, b.j, b.i});
      EXPECT_NEAR(d.to_i / b.volume, swapped.to_j / b.volume, 1e-12) << rule.name;
    });
  });
}

TEST(LiquidDivision, of_nothing_is_nothing) {
  for_each_choice<DivisionRule>([](auto rule) {
    const Division d = rule.divide({0.0, {1e-3, 0.2, 0.0}, {2e-3, 0.3, 0.0}});
    EXPECT_EQ(d.to_i, 0.0) << rule.name;
    EXPECT_EQ(d.to_j, 0.0) << rule.name;
  });
}

TEST(LiquidDivision, even_halves_whoever_gave) {
  const Division d = DivisionEven::divide({2e-12, {1e-3, 0.1, 2e-12}, {9e-3, 1.0, 0.0}});
  EXPECT_EQ(d.to_i, 1e-12);
  EXPECT_EQ(d.to_j, 1e-12);
}

TEST(LiquidDivision, own_share_returns_what_was_given_and_shares_a_loss) {
  const Division d = DivisionOwnShare::divide({4e-12, {1e-3, 0.1, 1e-12}, {1e-3, 1.0, 3e-12}});
  EXPECT_DOUBLE_EQ(d.to_i, 1e-12);
  EXPECT_DOUBLE_EQ(d.to_j, 3e-12);
  const Division dried = DivisionOwnShare::divide({2e-12, {1e-3, 0.1, 1e-12}, {1e-3, 1.0, 3e-12}});
  EXPECT_DOUBLE_EQ(dried.to_i, 0.5e-12);
  EXPECT_DOUBLE_EQ(dried.to_j, 1.5e-12);
  EXPECT_EQ(DivisionOwnShare::divide({2e-12, {1e-3, 0, 0}, {1e-3, 0, 0}}).to_i, 1e-12);
}

double share_i(double volume, Partner i, Partner j) {
  return DivisionShiMcCarthy::divide({volume, i, j}).to_i / volume;
}

TEST(ShiMcCarthy, equal_grains_share_evenly) {
  for (const double angle : {0.0, 0.4, 1.2, right_angle})
    EXPECT_NEAR(share_i(1e-12, {1e-3, angle, 0}, {1e-3, angle, 1e-12}), 0.5, 1e-15);
}

TEST(ShiMcCarthy, the_better_wetted_and_the_larger_grain_hold_more) {
  EXPECT_GT(share_i(1e-12, {1e-3, 0.2, 0}, {1e-3, 0.4, 0}), 0.55);
  EXPECT_GT(share_i(1e-12, {5e-3, 0.2, 0}, {1e-3, 0.2, 0}), 0.55);
  EXPECT_GT(share_i(1e-12, {wall, 0.2, 0}, {1e-3, 0.2, 0}), 0.55);
}

// cot^5 30 degrees / cot^5 60 degrees = 3^5; the caps' share is still 1e-3 of it at V / r^3 =
// 1e-15.
TEST(ShiMcCarthy, small_volumes_between_partly_wetted_grains_part_as_cot_to_the_fifth) {
  const double share = share_i(1e-24, {1e-3, pi / 6, 0}, {1e-3, pi / 3, 0});
  EXPECT_NEAR(share / (1.0 - share), 243.0, 2.0);
}

TEST(ShiMcCarthy, small_volumes_between_wetted_grains_part_as_the_radius_to_five_thirds) {
  const double share = share_i(1e-22, {8e-3, 0.0, 0}, {1e-3, 0.0, 0});
  EXPECT_NEAR(share / (1.0 - share), 32.0, 0.5);
}

TEST(ShiMcCarthy, an_unwetted_side_keeps_nothing_and_a_wetted_wall_all) {
  EXPECT_EQ(share_i(1e-12, {1e-3, right_angle, 0}, {1e-3, 0.5, 0}), 0.0);
  EXPECT_EQ(share_i(1e-12, {1e-3, 0.5, 0}, {1e-3, right_angle, 0}), 1.0);
  EXPECT_EQ(share_i(1e-12, {wall, 0.0, 0}, {1e-3, 0.0, 0}), 1.0);
  // and are approached without a step
  EXPECT_LT(share_i(1e-12, {1e-3, right_angle - 1e-3, 0}, {1e-3, 0.5, 0}), 1e-6);
  EXPECT_GT(share_i(1e-12, {wall, 1e-2, 0}, {1e-3, 0.0, 0}), 0.99);
}

// The meridian put together from the two sides: total liquid by quadrature of y = k x^2 minus the
// caps, contact angle at either end, and its share.
TEST(ShiMcCarthy, the_shares_are_those_of_a_parabola_that_meets_both_grains_at_their_angles) {
  const double volume = 2e-12;
  const Partner i{1e-3, 0.3, 0}, j{2.5e-3, 0.5, 0};
  // By trial: k of the parabola such that both sides sum to the volume.
  const auto side = [](const Partner& p, double k) {
    double x = 0.0, step = 0.1 * p.radius;  // end of the meridian: slope cot(beta + theta)
    const auto slope_misses = [&](double at) {
      const double y = k * at * at;
      if (y >= p.radius) return true;
      return std::atan(2.0 * k * at) + std::asin(y / p.radius) + p.contact_angle > right_angle;
    };
    for (int n = 0; n < 300; ++n) {
      if (slope_misses(x + step))
        step *= 0.5;
      else
        x += step;
    }
    const double y = k * x * x, height = p.radius - std::sqrt(p.radius * p.radius - y * y);
    double liquid = 0.0;
    const int cells = 20000;
    for (int n = 0; n < cells; ++n) {
      const double at = (n + 0.5) * x / cells;
      liquid += pi * std::pow(k * at * at, 2) * x / cells;
    }
    return liquid - pi * height * (3.0 * y * y + height * height) / 6.0;  // 5.79
  };
  double low = 1.0, high = 1e9;
  for (int n = 0; n < 60; ++n) {
    const double k = std::sqrt(low * high);
    (side(i, k) + side(j, k) > volume ? low : high) = k;
  }
  EXPECT_NEAR(share_i(volume, i, j), side(i, low) / volume, 1e-5);  // midpoint rule
}

}  // namespace
}  // namespace gasgrain::liquid
