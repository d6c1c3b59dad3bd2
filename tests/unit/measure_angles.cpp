// Angles that `gasgrain run` measures, of heaps and slopes of known angle; and its words where a
// run left none.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/measure_cases.h"

namespace gasgrain {
namespace {

// Grains of 0.6 mm, strewn densely through a cone of this angle, 40 mm wide, at (0.05, -0.02);
// their vz is `fall`.
std::vector<std::string> cone(double degrees, double fall = 0.0) {
  constexpr double d = 6e-4;
  constexpr double foot = 0.02;
  constexpr double grains_per_cube = 2.0;  // of a side d: nowhere is the floor seen
  const double slope = std::tan(degrees * M_PI / 180.0);
  std::mt19937 chance(1);
  std::uniform_real_distribution<double> across(-foot, foot);
  std::uniform_real_distribution<double> up(0.0, slope * foot);
  std::vector<std::string> lines;
  const double cubes = 4.0 * foot * foot * slope * foot / (d * d * d);
  for (int n = 0; n < grains_per_cube * cubes; ++n) {
    const double x = across(chance);
    const double y = across(chance);
    const double z = up(chance);
    if (z < slope * (foot - std::hypot(x, y)))
      lines.push_back(
          fmt::format("{} {} {} {} 0 0 {} {}", n, 0.05 + x, -0.02 + y, z, fall, 0.5 * d));
  }
  return lines;
}

TEST(AngleOfRepose, of_a_cone_is_the_cones_angle) {
  for (const double degrees : {10.0, 20.0, 30.0, 40.0}) {
    const fs::path folder = fresh_folder("cone");
    write(folder / "particles/heap.dump", frame(5, "id x y z vx vy vz radius", cone(degrees)));
    const Measurement cone = measured(folder, "[measure]\nkind = \"angle_of_repose\"\n");
    ASSERT_EQ(cone.quantities.front().name, "angle_of_repose");
    // A scatter of 0.3 grains in the height of some 1000 grains that are seen, over 20 of flank.
    EXPECT_NEAR(cone.quantities.front().value, degrees, 0.5);
    EXPECT_GT(cone.quantities.front().uncertainty, 0.0);
    EXPECT_LT(cone.quantities.front().uncertainty, 1.0);
  }
}

TEST(AngleOfRepose, of_the_last_frame_counts) {
  const fs::path folder = fresh_folder("frames");
  write(folder / "particles/heap.dump", frame(5, "id x y z vx vy vz radius", cone(40.0)) +
                                            frame(6, "id x y z vx vy vz radius", cone(20.0)));
  const auto heap = measured(folder, "[measure]\nkind = \"angle_of_repose\"\n");
  EXPECT_NEAR(heap.quantities.front().value, 20.0, 0.5);
}

TEST(AngleOfRepose, of_grains_that_still_move_is_told) {
  const fs::path folder = fresh_folder("moving");
  const std::string toml = "[measure]\nkind = \"angle_of_repose\"\n";
  // sqrt(g d) is 77 mm/s.
  write(folder / "particles/heap.dump", frame(5, "id x y z vx vy vz radius", cone(20.0, -0.006)));
  EXPECT_TRUE(measured(folder, toml).notes.empty());
  write(folder / "particles/heap.dump", frame(5, "id x y z vx vy vz radius", cone(20.0, -0.01)));
  EXPECT_EQ(measured(folder, toml).notes.size(), 1U);
}

TEST(AngleOfRepose, is_refused_where_there_is_no_heap) {
  const fs::path folder = fresh_folder("no_heap");
  const std::string toml = "[measure]\nkind = \"angle_of_repose\"\n";
  EXPECT_NE(refusal(folder, toml).find("heap.dump is absent"), std::string::npos);
  write(folder / "particles/heap.dump",
        frame(5, "id x y z vx vy vz radius", {"1 0 0 0.1 0 0 0 0.1"}));
  EXPECT_NE(refusal(folder, toml).find("1 grains lie above z = 0 m"), std::string::npos);
  write(folder / "particles/heap.dump", frame(5, "id x y height vx vy vz radius", cone(20.0)));
  EXPECT_NE(refusal(folder, toml).find("the dump has no column z"), std::string::npos);
  const std::string whole = frame(5, "id x y z vx vy vz radius", cone(20.0));
  write(folder / "particles/heap.dump", whole.substr(0, whole.rfind(' ')));
  EXPECT_NE(refusal(folder, toml).find("is cut short"), std::string::npos);
  std::vector<std::string> layer;
  for (int n = 0; n < 400; ++n)
    layer.push_back(fmt::format("{} {} {} 0.5 0 0 0 0.5", n, n % 20, n / 20));
  write(folder / "particles/heap.dump", frame(5, "id x y z vx vy vz radius", layer));
  EXPECT_NE(refusal(folder, toml).find("diameters: that is no heap"), std::string::npos);
}

// Grains of 0.6 mm, strewn densely over a bottom at -0.01, up to a plane of this angle.
std::vector<std::string> slope(double degrees, double bottom) {
  constexpr double d = 6e-4;
  constexpr double length = 0.03;
  constexpr double depth = 0.01;
  const double rise = std::tan(degrees * M_PI / 180.0);
  std::mt19937 chance(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double high = rise * length - bottom;
  std::vector<std::string> lines;
  for (int n = 0; n < 2.0 * length * depth * high / (d * d * d); ++n) {
    const double x = length * share(chance);
    const double y = depth * share(chance);
    const double z = bottom + high * share(chance);
    if (z < rise * (length - x))
      lines.push_back(fmt::format("{} {} {} {} 0 0 0 {}", n, x, y, z, 0.5 * d));
  }
  return lines;
}

TEST(DrainedAngle, of_a_slope_is_the_slopes_angle) {
  for (const double degrees : {15.0, 35.0}) {
    const fs::path folder = fresh_folder("slope");
    write(folder / "particles/slope.dump",
          frame(5, "id x y z vx vy vz radius", slope(degrees, 0.0)));
    const auto box = measured(folder, "[measure]\nkind = \"drained_angle\"\n");
    // As of a cone, with a scatter of 0.3 grains of 800 that are seen.
    EXPECT_NEAR(box.quantities.front().value, degrees, 0.5);
    EXPECT_LT(box.quantities.front().uncertainty, 0.5);
  }
}

TEST(DrainedAngle, of_an_empty_box_is_refused) {
  const fs::path folder = fresh_folder("drained");
  write(folder / "particles/slope.dump",
        frame(5, "id x y z vx vy vz radius", {"1 0 0 -0.1 0 0 0 0.1"}));
  EXPECT_NE(refusal(folder, "[measure]\nkind = \"drained_angle\"\n").find("the box is empty"),
            std::string::npos);
}

TEST(DynamicAngle, is_the_mean_over_the_frames) {
  const fs::path folder = fresh_folder("drum");
  std::string frames;
  for (int n = 0; n < 4; ++n)
    frames += frame(n, "id x y z vx vy vz radius", slope(n < 2 ? 28.0 : 32.0, -0.01));
  write(folder / "particles/drum.dump", frames);
  const auto drum = measured(folder, "[measure]\nkind = \"dynamic_angle\"\nblocks = 2\n");
  EXPECT_NEAR(drum.quantities.front().value, 30.0, 0.5);
  // Two blocks 4 degrees apart: 4 / 2.
  EXPECT_NEAR(drum.quantities.front().uncertainty, 2.0, 0.3);
  EXPECT_NE(refusal(folder, "[measure]\nkind = \"dynamic_angle\"\n").find("4 frames are too few"),
            std::string::npos);
}

}  // namespace
}  // namespace gasgrain
