// JKR's closed form against its implicit equations, its published figures and Hertz.
#include "fix_cfd_coupling/dem_physics/adhesion/jkr.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace gasgrain::adhesion {
namespace {

// 0.1 mm of glass, softened or not, with 0.1 J/m2.
constexpr double radius = 2.5e-5;
constexpr double work = 0.1;
const Jkr soft{1e7, radius, work};
const Jkr hard{4e10, radius, work};

// From the snap to a contact a thousand times as deep; near the snap q is the double root of its
// equation, where round-off of 1e-16 in delta is 1e-8 in a.
TEST(jkr, the_force_meets_both_implicit_equations) {
  for (const Jkr& law : {soft, hard}) {
    const double deep = -law.snap_overlap();
    for (const double share : {-1.0, -0.999, -0.5, -1e-3, 0.0, 1e-9, 1e-3, 0.3, 1.0, 30.0, 1e3}) {
      const double delta = share * deep;
      const double a = law.contact_radius(delta);
      const double tensile = std::sqrt(2.0 * contact::pi * work * a / law.modulus);
      EXPECT_NEAR((a * a / radius - tensile) / deep, share, 1e-13 * std::max(1.0, share)) << share;
      const double force = 4.0 * law.modulus * a * a * a / (3.0 * radius) -
                           std::sqrt(8.0 * contact::pi * work * law.modulus * a * a * a);
      EXPECT_NEAR(law.repulsion(delta) / law.pull_off_force(), force / law.pull_off_force(),
                  1e-12 * std::max(1.0, std::abs(force / law.pull_off_force())));
    }
  }
}

// A scan of the closed form: its least value is the pull-off force, wherever it lies.
TEST(jkr, the_greatest_pull_is_three_halves_pi_w_r_whatever_the_modulus) {
  for (const Jkr& law : {soft, hard}) {
    double least = 0.0;
    for (int n = 0; n <= 100000; ++n)
      least = std::min(least, law.repulsion(law.snap_overlap() * (1.0 - n * 1e-5)));
    EXPECT_NEAR(least / (-1.5 * contact::pi * work * radius), 1.0, 1e-8);
  }
}

TEST(jkr, snaps_at_five_ninths_and_touches_at_eight_ninths_of_the_pull_off_force) {
  EXPECT_NEAR(soft.repulsion(soft.snap_overlap()) / soft.pull_off_force(), -5.0 / 9.0, 1e-7);
  EXPECT_NEAR(soft.repulsion(0.0) / soft.pull_off_force(), -8.0 / 9.0, 1e-14);
}

// The snap is where the neck's branch ends: da/d delta is infinite.
TEST(jkr, the_neck_ends_where_its_radius_falls_infinitely_steeply) {
  const double end = soft.snap_overlap();
  const auto slope = [&](double h) {
    return (soft.contact_radius(end * (1.0 - h)) - soft.contact_radius(end)) / (-end * h);
  };
  EXPECT_GT(slope(1e-8) / slope(1e-4), 50.0);  // a root: 1e2
}

TEST(jkr, without_surface_energy_is_hertz_bit_for_bit_and_adds_nothing) {
  const Jkr off{1e7, radius, 0.0};
  for (const double delta : {0.0, 1e-9, 1e-6}) {
    EXPECT_EQ(off.repulsion(delta),
              contact::hertz_stiffness(1e7, radius) * delta * std::sqrt(delta));
    EXPECT_EQ(off.attraction(delta), 0.0);
  }
  EXPECT_EQ(off.repulsion(-1e-9), 0.0);
  EXPECT_FALSE(off.touches(0.0, true));
  EXPECT_FALSE(off.touches(-1e-30, true));
}

// What is off Hertz's force goes with the square root of w.
TEST(jkr, becomes_hertz_as_the_surface_energy_goes_to_zero) {
  const double delta = 1e-6;
  double last = 1.0;
  for (const double w : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Jkr law{1e7, radius, w};
    const double error = 1.0 - law.repulsion(delta) / law.hertz(delta);
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.15 * last);  // the square root of 1/100 is 0.1
    last = error;
  }
  EXPECT_LT(last, 1e-4);
}

TEST(jkr, holds_on_below_zero_overlap_only_what_it_touched) {
  EXPECT_TRUE(soft.touches(1e-9, false));
  EXPECT_FALSE(soft.touches(0.5 * soft.snap_overlap(), false));
  EXPECT_TRUE(soft.touches(0.5 * soft.snap_overlap(), true));
  EXPECT_FALSE(soft.touches(1.0001 * soft.snap_overlap(), true));
}

// Thornton and Ning (1998): 7.09; and the force itself, integrated by Simpson's rule along the
// neck. Its end is a root in delta, hence the substitution delta = snap (1 - u^2).
TEST(jkr, a_cycle_takes_the_published_work) {
  for (const Jkr& law : {soft, hard}) {
    const double published =
        std::cbrt(std::pow(work, 5) * std::pow(radius, 4) / (law.modulus * law.modulus));
    EXPECT_NEAR(law.work_of_cycle() / published, 7.09, 5e-3);
    const int intervals = 2000;
    double sum = 0.0;
    for (int n = 0; n <= intervals; ++n) {
      const double u = static_cast<double>(n) / intervals;
      const double weight = n == 0 || n == intervals ? 1.0 : (n % 2 == 1 ? 4.0 : 2.0);
      sum += weight * -law.repulsion(law.snap_overlap() * (1.0 - u * u)) * 2.0 * u;
    }
    const double integral = -law.snap_overlap() * sum / (3.0 * intervals);
    EXPECT_NEAR(law.work_of_cycle() / integral, 1.0, 1e-6);
  }
}

// The curve in its parameter q, from the snap to an overlap of a tenth of the radius: F and delta
// are polynomials in q, hence finite and without a jump. Near q = 1 delta tells q to 1e-8 only.
TEST(jkr, follows_its_parametric_form_from_the_snap_to_a_tenth_of_the_radius) {
  const double unit = soft.snap_radius() * soft.snap_radius() / radius;
  double deepest = 0.0;
  for (double q = 1.0; deepest < 0.1 * radius; q += 1e-3) {
    const double q3 = q * q * q;
    deepest = unit * (q * q3 - 4.0 * q);
    const double force = (q3 * q3 - 6.0 * q3) / 9.0;  // in pull-off forces
    ASSERT_NEAR(soft.repulsion(deepest) / soft.pull_off_force(), force,
                1e-7 + 1e-12 * std::abs(force))
        << q;
  }
  for (const double delta : {-1.0, 2.0 * soft.snap_overlap(), radius})
    EXPECT_TRUE(std::isfinite(soft.repulsion(delta)));
}

TEST(jkr, the_work_of_adhesion_of_one_material_is_twice_its_surface_energy) {
  EXPECT_NEAR(work_of_adhesion(0.05, 0.05), 0.1, 1e-15);
  EXPECT_NEAR(work_of_adhesion(0.05, 0.05, 0.0), 0.1, 1e-15);
  EXPECT_NEAR(work_of_adhesion(0.04, 0.09), 0.12, 1e-15);
  EXPECT_NEAR(work_of_adhesion(0.04, 0.09, 0.01), 0.12,
              1e-15);  // Girifalco and Good's own interface
}

// mu^3 = R w^2 / (E^2 z0^3), with round figures: 1e-6 1e-2 / (1e14 1e-27) = 1e5.
TEST(jkr, tabors_number_is_that_of_its_definition) {
  EXPECT_NEAR((Jkr{1e7, 1e-6, 0.1}.tabor_number(1e-9)), std::cbrt(1e5), 1e-10);
}

TEST(jkr, refuses_what_cannot_be_and_names_all_of_it) {
  const auto message = [](const Jkr& law) -> std::string {
    try {
      check(law);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(soft), "");
  EXPECT_EQ(message(Jkr{1e7, radius, 0.0}), "");
  const std::string text = message(Jkr{0.0, -1.0, -0.1});
  for (const char* name : {"effective modulus = 0 Pa must be above 0", "reduced radius = -1 m",
                           "work of adhesion = -0.1 J/m2 must be 0 or above"})
    EXPECT_NE(text.find(name), std::string::npos) << text;
}

}  // namespace
}  // namespace gasgrain::adhesion
