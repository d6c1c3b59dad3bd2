// Restitutions and stresses that `gasgrain run` measures, of known velocities and courses.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/measure_cases.h"
#include "tools/measure/series.h"

namespace gasgrain {
namespace {

// Walton's impact of a homogeneous sphere of radius 1 at 1 m/s: mu 0.25, e 0.8, and a contact point
// that comes to rest where friction suffices.
std::string walton(int id, double degrees, bool after) {
  const double angle = degrees * M_PI / 180.0;
  const double v_n = std::cos(angle);
  const double v_t = std::sin(angle);
  if (!after) return fmt::format("{} 0 0 2 {} 0 {} 0 0 0 1", id, v_t, -v_n);
  const double push = std::min(0.25 * 1.8 * v_n, 2.0 / 7.0 * v_t);
  return fmt::format("{} 0 0 2 {} 0 {} 0 {} 0 1", id, v_t - push, 0.8 * v_n, 2.5 * push);
}

TEST(ObliqueImpact, of_waltons_spheres_gives_his_constants) {
  const fs::path folder = fresh_folder("impact");
  std::vector<std::string> before;
  std::vector<std::string> after;
  for (int n = 1; n < 17; ++n) {
    before.push_back(walton(n, 5.0 * n, false));
    after.insert(after.begin(), walton(n, 5.0 * n, true));
  }
  const std::string columns = "id x y z vx vy vz omegax omegay omegaz radius";
  write(folder / "particles/impact.dump", frame(0, columns, before) + frame(9, columns, after));
  const auto impacts =
      measured(folder, "[measure]\nkind = \"oblique_impact\"\nimpact_angle = 45\n");
  const auto value = [&](const std::string& name) {
    for (const auto& one : impacts.quantities)
      if (one.name == name) return one.value;
    return std::nan("");
  };
  constexpr double round_off = 1e-5;  // of the text
  EXPECT_NEAR(value("normal_restitution"), 0.8, round_off);
  EXPECT_NEAR(value("sliding_friction"), 0.25, round_off);
  EXPECT_NEAR(value("tangential_restitution"), 5.0 / 7.0, round_off);
  EXPECT_NEAR(value("rebound_angle"), std::atan(5.0 / 7.0 / 0.8) * 180.0 / M_PI, 1e-3);
  EXPECT_NEAR(value("rebound_spin"), 5.0 / 7.0 * std::sin(M_PI / 4), round_off);
  EXPECT_TRUE(impacts.notes.empty());
  // Those that slide, from atan(7/2 mu (1 + e)) = 57.6 degrees on, lie on the line.
  for (const auto& row : impacts.curve.rows) {
    if (row.front() > 58.0) {
      EXPECT_NEAR(row[2], row.back(), round_off) << row.front();
    }
  }
  EXPECT_EQ(
      measured(folder, "[measure]\nkind = \"oblique_impact\"\nsliding_from = 40\n").notes.size(),
      1U);
  EXPECT_NE(refusal(folder, "[measure]\nkind = \"oblique_impact\"\nimpact_angle = 85\n")
                .find("outside of the impacts"),
            std::string::npos);
}

TEST(ConstrainedModulus, of_a_linear_spring_is_its_stiffness) {
  const fs::path folder = fresh_folder("compression");
  std::string text = "time_s,height_m,solid_fraction,stress_Pa\n";
  for (int n = 0; n <= 400; ++n) {
    const double height = 1.0 - 1e-4 * n;
    // From a height of 0.99 on, 5e5 Pa a metre.
    text += fmt::format("{},{},0.6,{}\n", n, height, std::max(0.0, 5e5 * (0.99 - height)));
  }
  write(folder / "history.csv", text);
  const std::string kind = "[measure]\nkind = \"constrained_modulus\"\n";
  const auto press = measured(folder, kind + "stress_from = 1010\nstress_to = 10010\n");
  // The strain counts from the first reading above 1010 Pa, a height of 0.9879 m.
  EXPECT_NEAR(press.quantities.front().value, 5e5 * 0.9879, 1.0);
  EXPECT_NEAR(press.quantities.front().uncertainty, 0.0, 1.0);
  EXPECT_NE(refusal(folder, kind + "stress_from = 1000\nstress_to = 20000\n")
                .find("never exceeds stress_to = 20000 Pa"),
            std::string::npos);
  EXPECT_NE(refusal(folder, kind + "stress_from = 1010\nstress_to = 1200\n").find("too few"),
            std::string::npos);
}

TEST(InternalFriction, is_that_of_the_mean_stresses_after_the_start) {
  const fs::path folder = fresh_folder("shear");
  std::string text =
      "time_s,shear_strain,height_m,solid_fraction,shear_stress_Pa,normal_stress_Pa\n";
  for (int n = 0; n < 1000; ++n)
    text += fmt::format("{},{},1,0.6,{},1000\n", n, 1e-3 * n,
                        n < 300 ? 9e9 : 577.35 + (n % 2 == 0 ? 100.0 : -100.0));
  write(folder / "history.csv", text);
  const std::string kind = "[measure]\nkind = \"internal_friction\"\n";
  const auto shear = measured(folder, kind);
  EXPECT_NEAR(shear.quantities.front().value, 30.0, 1e-3);  // atan(0.57735)
  EXPECT_NE(refusal(folder, kind + "from_strain = 0.99\n").find("shear further"),
            std::string::npos);
  write(folder / "history.csv", "time_s,shear_strain\n1,2\n");
  EXPECT_NE(refusal(folder, kind).find("has no numbers in a column shear_stress_Pa"),
            std::string::npos);
}

TEST(BlockMeans, have_the_standard_error_of_their_blocks) {
  const BlockMean mean = block_mean({1, 3, 2, 4, 6, 8}, 3);
  EXPECT_DOUBLE_EQ(mean.value, 4.0);
  // Means 2, 3, 7: variance 7, over 3.
  EXPECT_DOUBLE_EQ(mean.uncertainty, std::sqrt(7.0 / 3.0));
  EXPECT_THROW(block_mean({1.0}, 2), Error);
}

TEST(NormalRestitution, is_the_mean_of_the_grains) {
  const fs::path folder = fresh_folder("bounce");
  const std::string columns = "id z vz radius";
  write(folder / "particles/bounce.dump", frame(0, columns, {"1 2 -1 1", "2 2 -2 1"}) +
                                              frame(9, columns, {"2 2 1.2 1", "1 2 0.8 1"}));
  const auto bounce = measured(folder, "[measure]\nkind = \"normal_restitution\"\n");
  EXPECT_NEAR(bounce.quantities.front().value, 0.7, 1e-12);
  EXPECT_NEAR(bounce.quantities.front().uncertainty, 0.1, 1e-12);
  EXPECT_TRUE(bounce.notes.empty());
}

TEST(NormalRestitution, of_a_grain_that_stays_is_zero_and_is_told) {
  const fs::path folder = fresh_folder("stuck");
  const std::string columns = "id z vz radius";
  write(folder / "particles/bounce.dump",
        frame(0, columns, {"1 2 -1 1"}) + frame(9, columns, {"1 0.9 0 1"}));
  const auto bounce = measured(folder, "[measure]\nkind = \"normal_restitution\"\n");
  EXPECT_EQ(bounce.quantities.front().value, 0.0);
  EXPECT_EQ(bounce.notes.size(), 1U);
}

TEST(NormalRestitution, is_refused_where_the_impact_is_not_over) {
  const fs::path folder = fresh_folder("short");
  const std::string columns = "id z vz radius";
  const std::string toml = "[measure]\nkind = \"normal_restitution\"\n";
  const std::string before = frame(0, columns, {"1 2 -1 1"});
  write(folder / "particles/bounce.dump", before);
  EXPECT_NE(refusal(folder, toml).find("in 1 frames"), std::string::npos);
  write(folder / "particles/bounce.dump", before + frame(9, columns, {"1 0.9 0.5 1"}));
  EXPECT_NE(refusal(folder, toml).find("in touch with the plate"), std::string::npos);
  write(folder / "particles/bounce.dump", before + frame(9, columns, {"1 1.5 -1 1"}));
  EXPECT_NE(refusal(folder, toml).find("has not come to the plate"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain
