// Syamlal's drag between two solid phases: its limits and its symmetries.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tools/analyse/syamlal_drag.h"

namespace gasgrain {
namespace {

constexpr double round_off = 1e-13;  // some ten products and sums

SolidPhase small_phase() {
  return {0.1, 2500.0, 5e-4, Vec3(0.1, -0.2, -0.5)};
}
SolidPhase big_phase() {
  return {0.3, 900.0, 2.5e-3, Vec3(0.05, 0.3, 0.0)};
}

TEST(SyamlalDrag, of_a_heavy_sphere_in_a_beam_is_the_momentum_of_its_impacts) {
  // A beam of grains hits a sphere without friction: each gives (1 + e) m u cos^2(theta), in the
  // mean over the section half of that.
  const double e = 0.8;
  const double u = 0.5;
  const double volume = 1e-3;
  const double d = 5e-3;
  const SolidPhase s{1e-6, 2500.0, 5e-4, Vec3(0.0, 0.0, -u)};
  const SolidPhase b{pi / 6.0 * d * d * d / volume, 2.5e9, d, Vec3::Zero()};
  const double section = pi / 4.0 * (s.diameter + b.diameter) * (s.diameter + b.diameter);
  const double impacts = 0.5 * (1.0 + e) * s.fraction * s.density * u * u * section;
  const Vec3 rate = syamlal_drag(s, b, e, 0.0);
  // g0 is 1 to some 1e-4 here; of the inertia 1e-9 is the small sphere's.
  EXPECT_NEAR(rate.z() * volume / impacts, contact_distribution(s, b), 1e-8);
  EXPECT_NEAR(contact_distribution(s, b), 1.0, 1e-3);
  EXPECT_DOUBLE_EQ(rate.x(), 0.0);
}

TEST(SyamlalDrag, of_two_alike_phases_has_the_contact_value_of_percus_and_yevick) {
  for (const double eta : {0.05, 0.2, 0.5}) {
    const SolidPhase s{0.25 * eta, 2500.0, 1e-3, Vec3::Zero()};
    const SolidPhase b{0.75 * eta, 2500.0, 1e-3, Vec3::Zero()};
    EXPECT_NEAR(contact_distribution(s, b), (1.0 + 0.5 * eta) / ((1.0 - eta) * (1.0 - eta)), 1e-13);
  }
}

TEST(SyamlalDrag, grows_with_the_square_of_the_slip_and_with_friction_as_printed) {
  const SolidPhase s = small_phase();
  SolidPhase b = big_phase();
  const Vec3 once = syamlal_drag(s, b, 0.95, 0.0);
  b.velocity = s.velocity + 3.0 * (b.velocity - s.velocity);
  EXPECT_LT((syamlal_drag(s, b, 0.95, 0.0) - 9.0 * once).norm(), round_off * 9.0 * once.norm());
  const Vec3 rough = syamlal_drag(small_phase(), big_phase(), 0.95, 0.15);
  EXPECT_LT((rough - (1.0 + 0.15 * pi / 4.0) * once).norm(), round_off * rough.norm());
}

TEST(SyamlalDrag, of_the_one_is_the_opposite_of_the_other) {
  const Vec3 on_s = syamlal_drag(small_phase(), big_phase(), 0.95, 0.15);
  const Vec3 on_b = syamlal_drag(big_phase(), small_phase(), 0.95, 0.15);
  EXPECT_LT((on_s + on_b).norm(), round_off * on_s.norm());
  EXPECT_GT(on_s.dot(big_phase().velocity - small_phase().velocity), 0.0);
}

TEST(SyamlalDrag, turns_with_the_velocities_and_knows_no_frame_at_rest) {
  const Vec3 drag = syamlal_drag(small_phase(), big_phase(), 0.95, 0.15);
  SolidPhase s = small_phase();
  SolidPhase b = big_phase();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  s.velocity = turn * s.velocity;
  b.velocity = turn * b.velocity;
  EXPECT_LT((syamlal_drag(s, b, 0.95, 0.15) - turn * drag).norm(), round_off * drag.norm());
  const Vec3 wind(3.0, -2.0, 1.0);
  s.velocity = small_phase().velocity + wind;
  b.velocity = big_phase().velocity + wind;
  EXPECT_LT((syamlal_drag(s, b, 0.95, 0.15) - drag).norm(), 10.0 * round_off * drag.norm());
}

TEST(SyamlalDrag, is_nothing_without_slip_or_without_one_of_the_phases) {
  SolidPhase s = small_phase();
  SolidPhase b = big_phase();
  s.fraction = 0.0;
  EXPECT_EQ(syamlal_drag(s, b, 0.95, 0.15).norm(), 0.0);
  s = small_phase();
  b.velocity = s.velocity;
  EXPECT_EQ(syamlal_drag(s, b, 0.95, 0.15).norm(), 0.0);
}

}  // namespace
}  // namespace gasgrain
