// Rolling friction: directions, limits, and a sphere that rolls out on a plane.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "fix_cfd_coupling/dem_physics/contact_time.h"
#include "fix_cfd_coupling/dem_physics/rolling/rolling_limited.h"
#include "fix_cfd_coupling/dem_physics/rolling/rolling_viscous.h"
#include "tests/refusal.h"

namespace gasgrain::rolling {
namespace {

const RollingViscous viscous{1e-3};
const RollingLimited limited{0.1, 1e-3};
const Vec3 normal = Vec3(1.0, 2.0, -0.5).normalized();
const Vec3 spin_i(30.0, -20.0, 5.0);
const Vec3 spin_j(-7.0, 11.0, 50.0);

TEST(relative_rolling, is_across_the_normal_whatever_its_sense_and_none_of_two_that_turn_as_one) {
  const Vec3 w = relative_rolling(spin_i, spin_j, normal);
  EXPECT_NEAR(w.dot(normal), 0.0, 1e-13);
  EXPECT_EQ(w, relative_rolling(spin_i, spin_j, -normal));
  EXPECT_EQ(relative_rolling(spin_i, spin_i, normal), Vec3::Zero().eval());
  EXPECT_NEAR(relative_rolling(9.0 * normal, Vec3::Zero(), normal).norm(), 0.0, 1e-13);  // torsion
}

// Two gears of like size: their surfaces do not slide on each other, yet they roll.
TEST(relative_rolling, of_two_gears_is_the_sum_of_their_spins) {
  const Vec3 z(0.0, 0.0, 1.0);
  EXPECT_NEAR(relative_rolling(3.0 * z, -3.0 * z, Vec3(1.0, 0.0, 0.0)).norm(), 6.0, 1e-14);
}

TEST(relative_rolling, is_the_same_for_an_observer_who_turns) {
  const Vec3 turn(4.0, 5.0, -6.0);
  const Vec3 seen = relative_rolling(spin_i - turn, spin_j - turn, normal);
  EXPECT_NEAR((seen - relative_rolling(spin_i, spin_j, normal)).norm(), 0.0, 1e-13);
}

template <class Law>
void torques_are_a_pair_that_takes_energy_and_turns_with_the_axes(const Law& law) {
  const auto torque = [&](const Vec3& i, const Vec3& j, const Vec3& n) {
    return law.torque(relative_rolling(i, j, n), 0.02, 1e-3);
  };
  const Vec3 on_i = torque(spin_i, spin_j, normal);
  EXPECT_GT(on_i.norm(), 0.0);
  EXPECT_NEAR((on_i + torque(spin_j, spin_i, -normal)).norm(), 0.0, 1e-15 * on_i.norm());
  EXPECT_LT(on_i.dot(spin_i - spin_j), 0.0);
  const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 1.0, 2.0).normalized());
  EXPECT_NEAR((torque(turn * spin_i, turn * spin_j, turn * normal) - turn * on_i).norm(), 0.0,
              1e-13 * on_i.norm());
  EXPECT_EQ(law.torque(Vec3::Zero(), 0.02, 1e-3), Vec3::Zero().eval());
  // the sense of the normal force does not drive a sphere
  EXPECT_EQ(law.torque(spin_i, -0.02, 1e-3), law.torque(spin_i, 0.02, 1e-3));
  for (const double size : {1e-300, 1e-30, 1.0, 1e30})
    EXPECT_TRUE(law.torque(Vec3(size, -size, size), 0.02, 1e-3).allFinite()) << size;
}

TEST(rolling_viscous, torques_are_a_pair_that_takes_energy_and_turns_with_the_axes) {
  torques_are_a_pair_that_takes_energy_and_turns_with_the_axes(viscous);
}
TEST(rolling_limited, torques_are_a_pair_that_takes_energy_and_turns_with_the_axes) {
  torques_are_a_pair_that_takes_energy_and_turns_with_the_axes(limited);
}

TEST(rolling_limited, is_the_viscous_law_for_slow_and_the_constant_torque_for_fast_rolling) {
  const Vec3 slow(50.0, 0.0, 0.0);  // k w = 0.05, half the limit
  EXPECT_EQ(limited.torque(slow, 0.02, 1e-3), viscous.torque(slow, 0.02, 1e-3));
  for (const double rate : {101.0, 1e3, 1e6})
    EXPECT_NEAR(limited.torque(Vec3(0.0, rate, 0.0), 0.02, 1e-3).y() / -(0.1 * 0.02 * 1e-3), 1.0,
                1e-14);
}

TEST(rolling_limited, has_no_jump_where_the_limit_begins) {
  const double below = limited.torque(Vec3(100.0 * (1.0 - 1e-12), 0, 0), 0.02, 1e-3).norm();
  const double above = limited.torque(Vec3(100.0 * (1.0 + 1e-12), 0, 0), 0.02, 1e-3).norm();
  EXPECT_NEAR(above / below, 1.0, 1e-11);
}

// 7/5 m R^2 dw/dt = M of a sphere that rolls on a plane without sliding; Heun's rule.
template <class Law>
double rolled_out(const Law& law, double rate, double time, double mass, double radius) {
  const int steps = 20000;
  const double dt = time / steps;
  const double inertia = 1.4 * mass * radius * radius;
  const auto slope = [&](double w) {
    return law.torque(Vec3(0.0, w, 0.0), mass * 9.81, radius).y() / inertia;
  };
  for (int n = 0; n < steps; ++n) {
    const double first = slope(rate);
    rate += 0.5 * dt * (first + slope(rate + dt * first));
  }
  return rate;
}

TEST(rolling_viscous, a_sphere_on_a_plane_slows_down_exponentially) {
  const double mass = 1e-5;
  const double radius = 1e-3;
  const double decay = 1e-3 * 9.81 / (1.4 * radius);  // [1/s]
  EXPECT_NEAR(rolled_out(viscous, 40.0, 0.3, mass, radius) / (40.0 * std::exp(-0.3 * decay)), 1.0,
              1e-7);
}

// Constant deceleration mu g / (7/5 R) down to the limit's rate of 100 rad/s, then the exponential.
TEST(rolling_limited, a_sphere_on_a_plane_slows_down_linearly_and_then_exponentially) {
  const double mass = 1e-5;
  const double radius = 1e-3;
  const double decay = 1e-3 * 9.81 / (1.4 * radius);
  const double linear = (400.0 - 100.0) / (0.1 * 9.81 / (1.4 * radius));  // [s]
  const double rate = rolled_out(limited, 400.0, linear + 0.2, mass, radius);
  EXPECT_NEAR(rate / (100.0 * std::exp(-0.2 * decay)), 1.0, 1e-6);
}

TEST(rolling_friction, of_no_strength_is_none_bit_for_bit) {
  const Vec3 w(3.0, -4.0, 5.0);
  const Vec3 before(0.1, 0.2, 0.3);
  EXPECT_EQ((before + RollingViscous{}.torque(w, 0.02, 1e-3)).eval(), before);
  EXPECT_EQ((before + RollingLimited{}.torque(w, 0.02, 1e-3)).eval(), before);
  EXPECT_EQ((before + RollingLimited{0.0, 1e-3}.torque(w, 0.02, 1e-3)).eval(), before);
}

TEST(rolling_friction, refuses_what_cannot_be_and_names_all_of_it) {
  EXPECT_EQ(message(viscous), "");
  EXPECT_EQ(message(limited), "");
  EXPECT_EQ(message(RollingLimited{}), "");
  EXPECT_NE(message(RollingViscous{-1.0}).find("time constant = -1 s"), std::string::npos);
  EXPECT_NE(message(RollingLimited{2.0, 1e-3}).find("friction = 2 must be at most 1"),
            std::string::npos);
  EXPECT_NE(message(RollingLimited{0.1, 0.0}).find("above 0 where there is friction"),
            std::string::npos);
  EXPECT_NE(message(RollingLimited{std::nan(""), 1e-3}), "");
}

}  // namespace
}  // namespace gasgrain::rolling
