// Bad numbers are refused in words.
#include <gtest/gtest.h>

#include <limits>

#include "fix_cfd_coupling/dem_physics/bridge/bridge_faults.h"
#include "tests/bridges/bridge_cases.h"

namespace gasgrain::bridge::test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

void expect_fault(const LiquidBridge& b, const std::string& words) {
  const auto faults = bridge_faults(b);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find(words), std::string::npos) << faults[0];
}

TEST(Faults, good_bridges_have_none) {
  for_each_bridge([](const LiquidBridge& b) { EXPECT_TRUE(bridge_faults(b).empty()); });
  EXPECT_TRUE(bridge_faults(equal_grains(0.0, 0.5 * pi)).empty());
  EXPECT_TRUE(viscous_faults(0.0, 1e-6).empty());
}

TEST(Faults, an_angle_in_degrees_is_told_in_radians) {
  expect_fault(equal_grains(1e-3, 30.0), "contact_angle = 30 is not allowed");
  expect_fault(equal_grains(1e-3, 30.0), "If it is in degrees, write 0.523599.");
  EXPECT_EQ(contact_angle_fault(0.5236), "");
  EXPECT_NE(contact_angle_fault(-0.1), "");
  EXPECT_EQ(contact_angle_fault(-0.1).find("degrees"), std::string::npos);
  EXPECT_NE(contact_angle_fault(nan), "");
}

TEST(Faults, negative_or_unreal_volume_tension_and_radius_are_refused) {
  LiquidBridge b = equal_grains(1e-3, 0.1);
  b.volume = -1e-12;
  expect_fault(b, "volume = -1e-12 is not allowed: give the liquid in m3, 0 or more");
  b.volume = nan;
  expect_fault(b, "volume = nan");
  b = equal_grains(1e-3, 0.1);
  b.surface_tension = -0.07;
  expect_fault(b, "surface_tension = -0.07 is not allowed: give N/m");
  b = equal_grains(1e-3, 0.1);
  b.radius = 0.0;
  expect_fault(b, "radius = 0");
}

TEST(Faults, all_of_them_are_told_at_once) {
  EXPECT_EQ(bridge_faults({-1.0, 45.0, -1.0, -1.0, false, 0.0}).size(), 4U);
  EXPECT_EQ(viscous_faults(-1.0, 0.0).size(), 2U);
}

TEST(Faults, a_minimum_separation_of_zero_is_refused_with_the_reason) {
  const auto faults = viscous_faults(1e-3, 0.0);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("the viscous force at contact is infinite"), std::string::npos);
}

TEST(Faults, a_law_knows_its_range) {
  EXPECT_TRUE(within_range<BridgeWillett>(equal_grains(1e-4, 0.1)));
  EXPECT_FALSE(within_range<BridgeWillett>(equal_grains(1e-2, 0.1)));
  EXPECT_FALSE(within_range<BridgeMikami>(equal_grains(1e-6, 0.1)));
  EXPECT_FALSE(within_range<BridgeLianToroid>(equal_grains(1e-2, 1.2)));
  // Mikami's is in the grain's own radius on a wall, an eighth of Derjaguin's cubed
  EXPECT_TRUE(within_range<BridgeMikami>(grain_on_wall(1.5e-4, 0.1)));
}

}  // namespace
}  // namespace gasgrain::bridge::test
