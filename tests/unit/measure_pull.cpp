// Force, rupture and work that `gasgrain run` measures of a pull, of a known course.
#include <gtest/gtest.h>

#include "tests/unit/measure_cases.h"

namespace gasgrain {
namespace {

constexpr const char* pull = "[measure]\nkind = \"force_distance\"\n";

// 2 N at touch, falling to half of it at 1 m, where it ends: 1.5 J.
std::string course(double from, double to, double step) {
  std::string text = "gap_m,force_N\n";
  for (double s = from; s < to; s += step)
    text += fmt::format("{:.9g},{:.9g}\n", s, s < 0.0 ? -50.0 : s < 1.0 ? 2.0 - s : 0.0);
  return text;
}

TEST(ForceDistance, of_a_straight_course_has_its_force_end_and_work) {
  const fs::path folder = fresh_folder("pull");
  write(folder / "history.csv", course(-0.101, 1.4, 0.002));  // odd: touch and end between readings
  const auto found = measured(folder, pull);
  ASSERT_EQ(found.quantities.size(), 3U);
  EXPECT_EQ(found.quantities[0].name, "greatest_force");
  EXPECT_NEAR(found.quantities[0].value, 1.999, 1e-9);  // of the first reading, 1 mm off
  EXPECT_EQ(found.quantities[1].name, "rupture_distance");
  EXPECT_NEAR(found.quantities[1].value, 1.0, 1e-9);
  EXPECT_NEAR(found.quantities[1].uncertainty, 1e-3, 1e-9);
  EXPECT_EQ(found.quantities[2].name, "pull_energy");
  EXPECT_NEAR(found.quantities[2].value, 1.5, 2e-6);  // half a reading at either end, squared
  EXPECT_NEAR(found.quantities[2].uncertainty, 1e-3, 2e-6);
  for (const auto& row : found.curve.rows) EXPECT_GE(row[0], 0.0);
}

TEST(ForceDistance, that_was_not_measured_to_its_end_is_refused) {
  const fs::path folder = fresh_folder("pull_short");
  const auto refused = [&](const std::string& text) {
    write(folder / "history.csv", text);
    return refusal(folder, pull);
  };
  const auto says = [](const std::string& message, const char* words) {
    return message.find(words) != std::string::npos;
  };
  EXPECT_TRUE(says(refused(course(0.0, 0.8, 0.01)), "pull further"));
  EXPECT_TRUE(says(refused(course(1.1, 1.8, 0.01)), "nothing holds the bodies together"));
  EXPECT_TRUE(says(refused(course(-0.5, -0.1, 0.01)), "stay in contact"));
  EXPECT_TRUE(says(refused(course(0.0, 1.8, 0.2)), "pull more slowly"));
  EXPECT_TRUE(says(refused("gap_m,force_N\n0.1,1\n0.2,1\n0.1,0\n"), "only goes apart"));
  EXPECT_TRUE(says(refusal(folder, "[measure]\nkind = \"force_distance\"\nhistry = \"a\"\n"),
                   "Did you mean \"history\"?"));
}

}  // namespace
}  // namespace gasgrain
