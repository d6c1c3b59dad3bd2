// Hamaker's forces against each other, against their energy and against published constants.
#include "fix_cfd_coupling/dem_physics/adhesion/van_der_waals.h"

#include <gtest/gtest.h>

#include <string>

#include "coupling/exchange/effect_sizes/van_der_waals.h"
#include "fix_cfd_coupling/dem_physics/adhesion/hamaker_constant.h"

namespace gasgrain::adhesion {
namespace {

constexpr double glass = 6.5e-20;  // A [J]

// Hamaker (1937): the energy whose derivative the force is. In long double, as its terms cancel.
long double hamaker_energy(long double a, long double r1, long double r2, long double s) {
  const long double r = r1 + r2 + s;
  const long double outer = r * r - (r1 + r2) * (r1 + r2);
  const long double inner = r * r - (r1 - r2) * (r1 - r2);
  return -a / 6 * (2 * r1 * r2 / outer + 2 * r1 * r2 / inner + std::log(outer / inner));
}

// The central difference with h = 1e-4 s is off by h^2 / s^2, some 1e-8; round-off by less.
TEST(van_der_waals, the_force_of_spheres_is_the_derivative_of_hamakers_energy) {
  for (const double ratio : {1.0, 3.0, 15.0})
    for (const double share : {1e-3, 0.1, 1.0}) {
      const long double r1 = 1e-6L;
      const long double r2 = r1 * ratio;
      const long double s = r1 * share;
      const long double h = 1e-4L * s;
      const long double slope =
          (hamaker_energy(glass, r1, r2, s + h) - hamaker_energy(glass, r1, r2, s - h)) / (2 * h);
      const double force = hamaker_spheres(glass, 1e-6, 1e-6 * ratio, 1e-6 * share);
      EXPECT_NEAR(force / static_cast<double>(slope), 1.0, 1e-6) << ratio << " " << share;
    }
}

TEST(van_der_waals, of_spheres_becomes_derjaguins_form_at_small_gaps_to_first_order_in_the_gap) {
  const double r1 = 2e-6;
  const double r2 = 7e-6;
  const double reduced = r1 * r2 / (r1 + r2);
  for (const double s : {1e-10, 1e-9}) {
    const double excess = hamaker_near(glass, reduced, s) / hamaker_spheres(glass, r1, r2, s) - 1.0;
    EXPECT_NEAR(excess / (s / reduced), 1.0, 3.0 * s / reduced);
  }
}

// E = -16/9 A (R1 R2)^3 / r^6 of two small bodies; the next term is of the order of (R/r)^2.
TEST(van_der_waals, of_spheres_far_apart_is_that_of_an_energy_of_r_to_the_minus_six) {
  const double r1 = 1e-9;
  const double r2 = 2e-9;
  for (const double r : {3e-7, 3e-6}) {
    const double far = 32.0 / 3.0 * glass * std::pow(r1 * r2, 3) / std::pow(r, 7);
    const double force = hamaker_spheres(glass, r1, r2, r - r1 - r2);
    EXPECT_NEAR(force / far, 1.0, 20.0 * r2 * r2 / (r * r));
  }
}

TEST(van_der_waals, a_wall_is_a_sphere_of_infinite_radius) {
  for (const double s : {4e-10, 1e-7, 1e-4}) {
    const double r = 5e-6;
    EXPECT_NEAR(hamaker_spheres(glass, r, 1e9 * s + 1e6, s) / hamaker_wall(glass, r, s), 1.0, 1e-8);
    EXPECT_NEAR(hamaker_wall(glass, r, s) /
                    (2.0 / 3.0 * glass * r * r * r / std::pow(s * (s + 2.0 * r), 2)),
                1.0, 1e-13);
  }
}

TEST(van_der_waals, acts_and_reacts_alike_and_is_finite_from_overlap_to_the_greatest_gap) {
  const VanDerWaals law{glass, 4e-10, 1e-6};
  for (const double gap : {-1e-3, -1e-9, 0.0, 4e-10, 5e-8, 1e-6, 1.0001e-6, 1.0}) {
    const double force = law.between_spheres(1e-6, 1.5e-5, gap);
    EXPECT_TRUE(std::isfinite(force));
    EXPECT_NEAR(force, law.between_spheres(1.5e-5, 1e-6, gap), 1e-14 * force);
    EXPECT_EQ(force > 0.0, gap <= 1e-6);
    EXPECT_EQ(law.to_wall(1e-6, gap) > 0.0, gap <= 1e-6);
  }
}

TEST(van_der_waals, is_greatest_and_constant_below_the_smallest_gap) {
  const VanDerWaals law{glass, 4e-10, 1e-6};
  const double greatest = hamaker_spheres(glass, 1e-6, 1e-6, 4e-10);
  EXPECT_EQ(law.between_spheres(1e-6, 1e-6, 4e-10), greatest);
  EXPECT_EQ(law.between_spheres(1e-6, 1e-6, 0.0), greatest);
  EXPECT_EQ(law.between_spheres(1e-6, 1e-6, -1e-8), greatest);
  EXPECT_LT(law.between_spheres(1e-6, 1e-6, 5e-10), greatest);
}

TEST(van_der_waals, the_gap_of_a_share_is_where_the_near_form_has_fallen_to_it) {
  const VanDerWaals law{glass, 4e-10, 1e-6};
  const double gap = law.gap_of_share(1e-4);
  EXPECT_NEAR(gap, 4e-8, 1e-20);
  EXPECT_NEAR(law.to_wall(1e-3, gap) / law.to_wall(1e-3, 0.0), 1e-4, 1e-8);
}

TEST(van_der_waals, of_no_hamaker_constant_is_zero_bit_for_bit) {
  const VanDerWaals off{};
  for (const double gap : {-1e-9, 0.0, 1e-8}) {
    EXPECT_EQ(off.between_spheres(1e-6, 2e-6, gap), 0.0);
    EXPECT_EQ(off.to_wall(1e-6, gap), 0.0);
  }
}

// The estimate takes an asperity on a wall, in the near form.
TEST(van_der_waals, is_what_the_estimate_of_its_size_says) {
  Scales at;
  at.diameter = 1e-4;
  EXPECT_NEAR(SizeVanDerWaals::force(at) / hamaker_near(6.5e-20, 1e-7, 4e-10), 1.0, 1e-14);
}

TEST(hamaker_constant, of_unlike_bodies_is_the_mean_and_of_like_ones_their_own) {
  EXPECT_NEAR(hamaker_of_unlike(4e-20, 9e-20), 6e-20, 1e-33);
  EXPECT_NEAR(hamaker_across(4e-20, 4e-20, 0.0), 4e-20, 1e-33);
  EXPECT_NEAR(hamaker_across(4e-20, 9e-20, 0.0), hamaker_of_unlike(4e-20, 9e-20), 1e-33);
  EXPECT_NEAR(hamaker_across(9e-20, 16e-20, 4e-20), 2e-20, 1e-33);
}

TEST(hamaker_constant, of_a_medium_between_the_materials_repels_and_of_the_same_medium_is_none) {
  EXPECT_LT(hamaker_across(1e-20, 9e-20, 4e-20), 0.0);
  EXPECT_EQ(hamaker_across(4e-20, 9e-20, 4e-20), 0.0);
  const VanDerWaals law{hamaker_across(1e-20, 9e-20, 4e-20), 4e-10, 1e-6};
  EXPECT_LT(law.between_spheres(1e-6, 1e-6, 1e-9), 0.0);
}

// Israelachvili's table of constants across vacuum, in zJ, given there to two digits.
TEST(hamaker_constant, of_permittivity_and_index_is_that_of_the_published_table) {
  const Dielectric vacuum{1.0, 1.0};
  const auto alone = [&](double e, double n, double f) {
    const Dielectric of{e, n};
    return hamaker_of_dielectrics(of, of, vacuum, f, 298.0) * 1e21;
  };
  EXPECT_NEAR(alone(80.0, 1.333, 3.0e15), 37.0, 1.5);  // water
  EXPECT_NEAR(alone(3.8, 1.448, 3.2e15), 63.0, 2.0);   // fused silica
  EXPECT_NEAR(alone(2.1, 1.359, 2.9e15), 38.0, 1.5);   // PTFE
}

TEST(hamaker_constant, of_lifshitzs_constant_is_a_quarter_of_it) {
  EXPECT_NEAR(hamaker_of_lifshitz_constant(4.0 * contact::pi / 3.0 * 1e-19), 1e-19, 1e-32);
}

template <class F>
std::string message(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(van_der_waals, refuses_what_cannot_be_and_names_all_of_it) {
  EXPECT_EQ(message([] { check(VanDerWaals{glass}); }), "");
  const std::string text = message([] { check(VanDerWaals{6.5, -1.0, -2.0}); });
  EXPECT_NE(text.find("Hamaker's constant = 6.5 J must be below 1e-17"), std::string::npos) << text;
  EXPECT_NE(text.find("smallest gap = -1 m must be above 0"), std::string::npos) << text;
  EXPECT_NE(text.find("greatest gap = -2 m must be above the smallest"), std::string::npos) << text;
  EXPECT_NE(message([] { check(VanDerWaals{std::nan("")}); }), "");
  EXPECT_NE(message([] { check_hamaker(-1e-20, 1e-20, 0.0); }).find("A_ii"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain::adhesion
