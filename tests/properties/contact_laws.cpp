// What holds for every cohesion law of the LIST, whatever the host: checked for a new one by its
// being listed.
#include "tests/properties/contact_laws.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"

namespace gasgrain::contact {
namespace {

using Laws = testing::Types<
#define COHESION_LAW(Law, name, id) Law,
#include "fix_cfd_coupling/dem_physics/contact/cohesion_laws.h"
#undef COHESION_LAW
    CohesionOff>;

template <class Law>
class CohesionLaws : public testing::Test {
 protected:
  static std::vector<PairForces> life(const PairMotion& motion) {
    return PairLife<Law>(motion).all();
  }
  // A gap of 2e-7 m is known to 1e-9 of itself, of which a force may be a power.
  static constexpr double of_gap = 1e-7;

  static void expect_near(const Vec3& a, const Vec3& b, double share) {
    EXPECT_LE((a - b).norm(), share * (a.norm() + b.norm()));
  }
};
TYPED_TEST_SUITE(CohesionLaws, Laws);

TYPED_TEST(CohesionLaws, act_on_grains_that_have_touched_and_part) {
  const auto steps = this->life({});
  const bool off = std::is_same_v<TypeParam, CohesionOff>;
  EXPECT_EQ(steps.back().force[0].norm() > 0.0, !off);
  EXPECT_EQ(steps.back().acts, !off);
}

TYPED_TEST(CohesionLaws, give_momentum_and_angular_momentum_to_nobody) {
  for (const PairForces& f : this->life({})) {
    EXPECT_EQ(f.force[0], -f.force[1]);
    const Vec3 orbit = f.between.cross(f.force[0]);
    // both grains' torques cancel what the force turns the pair by
    EXPECT_LE((orbit + f.torque[0] + f.torque[1]).norm(),
              1e-12 * (f.between.norm() * f.force[0].norm() + f.torque[0].norm()));
  }
}

TYPED_TEST(CohesionLaws, turn_with_the_observer) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  PairMotion turned;
  turned.normal = turn * turned.normal;
  for (int k = 0; k < 2; ++k) {
    turned.velocity[k] = turn * turned.velocity[k];
    turned.spin[k] = turn * turned.spin[k];
  }
  const auto here = this->life({});
  const auto there = this->life(turned);
  for (std::size_t n = 0; n < here.size(); ++n) {
    this->expect_near(turn * here[n].force[0], there[n].force[0], this->of_gap);
    this->expect_near(turn * here[n].torque[1], there[n].torque[1], this->of_gap);
  }
}

TYPED_TEST(CohesionLaws, are_the_same_for_an_observer_who_moves) {
  PairMotion moving;
  for (Vec3& v : moving.velocity) v += Vec3(0.4, 0.3, -0.2);
  const auto here = this->life({});
  const auto there = this->life(moving);
  for (std::size_t n = 0; n < here.size(); ++n)
    this->expect_near(here[n].force[0], there[n].force[0], this->of_gap);
}

TYPED_TEST(CohesionLaws, are_the_same_whoever_is_the_first_of_the_pair) {
  PairMotion swapped;
  swapped.swapped = true;
  const auto here = this->life({});
  const auto there = this->life(swapped);
  for (std::size_t n = 0; n < here.size(); ++n) {
    this->expect_near(here[n].force[0], there[n].force[0], 1e-12);
    this->expect_near(here[n].torque[0], there[n].torque[0], 1e-12);
  }
}

TYPED_TEST(CohesionLaws, remember_nothing_of_being_looked_at) {
  PairLife<TypeParam> life({});
  life.all();
  const auto before = life.history;
  life.step(life.gap, false);
  life.step(-life.overlap, false);
  EXPECT_EQ(life.history, before);
}

}  // namespace
}  // namespace gasgrain::contact
