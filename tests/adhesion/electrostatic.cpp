// Electrostatic forces against Coulomb's and Gauss's laws and exact results of potential theory.
#include "fix_cfd_coupling/dem_physics/adhesion/electrostatic.h"

#include <gtest/gtest.h>

#include <string>

#include "coupling/exchange/effect_sizes/electrostatics.h"
#include "fix_cfd_coupling/dem_physics/adhesion/contact_potential.h"
#include "tests/refusal.h"

namespace gasgrain::adhesion {
namespace {

TEST(electrostatic, of_two_coulombs_a_metre_apart_is_nine_giganewtons) {
  EXPECT_NEAR(Electrostatic{}.between_spheres(1.0, -1.0, 0.3, 0.2, 0.5) / 8.98755179e9, 1.0, 1e-8);
}

TEST(electrostatic, falls_with_the_square_of_the_distance_of_the_centres) {
  const Electrostatic law;
  const double near = law.between_spheres(1e-12, -1e-12, 1e-4, 2e-4, 0.0);
  const double twice = law.between_spheres(1e-12, -1e-12, 1e-4, 2e-4, 3e-4);
  EXPECT_NEAR(near / twice, 4.0, 1e-12);
}

TEST(electrostatic, unlike_charges_attract_like_ones_repel_both_grains_alike) {
  const Electrostatic law;
  EXPECT_GT(law.between_spheres(1e-12, -2e-12, 1e-4, 2e-4, 1e-5), 0.0);
  EXPECT_LT(law.between_spheres(-1e-12, -2e-12, 1e-4, 2e-4, 1e-5), 0.0);
  EXPECT_EQ(law.between_spheres(1e-12, -2e-12, 1e-4, 2e-4, 1e-5),
            law.between_spheres(-2e-12, 1e-12, 2e-4, 1e-4, 1e-5));
}

// A grounded conductor puts the opposite charge as far behind its face as the grain is before it.
TEST(electrostatic, of_a_wall_is_that_of_the_opposite_charge_behind_a_mirror) {
  const Electrostatic law;
  const double r = 1e-4;
  for (const double gap : {0.0, 1e-5, 1e-2})
    EXPECT_NEAR(law.to_wall(3e-13, r, gap) / law.between_spheres(3e-13, -3e-13, r, r, 2.0 * gap),
                1.0, 1e-12);
  EXPECT_EQ(law.to_wall(3e-13, r, 0.0), law.to_wall(-3e-13, r, 0.0));
}

TEST(electrostatic, an_insulating_wall_has_a_weaker_image_and_one_like_the_medium_has_none) {
  Electrostatic law;
  const double full = law.to_wall(1e-13, 1e-4, 1e-5);
  law.wall_permittivity = 3.0;
  EXPECT_NEAR(law.to_wall(1e-13, 1e-4, 1e-5) / full, 0.5, 1e-12);
  law.wall_permittivity = 1.0;
  EXPECT_EQ(law.to_wall(1e-13, 1e-4, 1e-5), 0.0);
  law = {};
  law.medium_permittivity = 4.0;
  EXPECT_NEAR(law.to_wall(1e-13, 1e-4, 1e-5) / full, 0.25, 1e-12);
}

// Eq 5.64: an evenly charged sheet pulls with phi / (2 eps0) wherever the grain is.
TEST(electrostatic, a_charged_wall_pulls_unlike_charges_the_same_at_any_gap) {
  Electrostatic law;
  law.wall_permittivity = 1.0;
  law.wall_charge = 1e-6;
  const double r = 1e-4;
  const double q = charge_of_sphere(-2e-6, r);
  const double sheet = 2.0 * contact::pi / vacuum_permittivity * 2e-6 * 1e-6 * r * r;
  EXPECT_NEAR(law.to_wall(q, r, 0.0) / sheet, 1.0, 1e-12);
  EXPECT_NEAR(law.to_wall(q, r, 1.0) / sheet, 1.0, 1e-12);
  EXPECT_LT(law.to_wall(-q, r, 0.0), 0.0);
}

// Eq 5.62 with the reduced diameter; see the header.
TEST(electrostatic, of_charges_per_area_is_the_insulators_law) {
  const double r1 = 1e-4;
  const double r2 = 3e-4;
  const double gap = 5e-5;
  const double diameter = 2.0 * r1 * r2 / (r1 + r2);
  const double law = contact::pi / vacuum_permittivity * 1e-6 * 2e-6 * diameter * diameter /
                     std::pow(1.0 + gap / (r1 + r2), 2);
  const double q1 = charge_of_sphere(1e-6, r1);
  const double q2 = charge_of_sphere(-2e-6, r2);
  EXPECT_NEAR(Electrostatic{}.between_spheres(q1, q2, r1, r2, gap) / law, 1.0, 1e-12);
}

// Gauss's law: the field at the surface of a sphere with the breakdown charge.
TEST(electrostatic, the_breakdown_charge_makes_the_breakdown_field_at_the_surface) {
  const Electrostatic law;
  const double r = 5e-4;
  const double q = law.breakdown_charge(r);
  EXPECT_NEAR(q / (4.0 * contact::pi * vacuum_permittivity * r * r), 3e6, 1e-6);
  EXPECT_FALSE(law.over_breakdown(q, r));
  EXPECT_TRUE(law.over_breakdown(-1.001 * q, r));
  EXPECT_NEAR(q, 8.34e-11, 1e-13);  // some 80 pC on a grain of a millimetre
}

// eps0 has four digits there.
TEST(electrostatic, at_breakdown_is_what_the_estimate_of_its_size_says) {
  Scales at;
  at.diameter = 1e-3;
  const Electrostatic law;
  const double q = law.breakdown_charge(5e-4);
  EXPECT_NEAR(law.between_spheres(q, -q, 5e-4, 5e-4, 0.0) / SizeElectrostatics::force(at), 1.0,
              1e-4);
}

TEST(electrostatic, is_finite_over_its_range_and_without_charge_zero_bit_for_bit) {
  const Electrostatic law;
  for (const double gap : {-5e-5, 0.0, 1e-9, 1.0}) {
    EXPECT_TRUE(std::isfinite(law.between_spheres(1e-12, 1e-12, 1e-4, 1e-4, gap)));
    EXPECT_TRUE(std::isfinite(law.to_wall(1e-12, 1e-4, gap)));
    EXPECT_EQ(law.between_spheres(0.0, 1e-12, 1e-4, 1e-4, gap), 0.0);
    EXPECT_EQ(law.to_wall(0.0, 1e-4, gap), 0.0);
    EXPECT_EQ(ContactPotential{}.attraction(1e-4, gap), 0.0);
  }
}

// Exact: W.R. Smythe's series of a conducting sphere above a grounded plane, cosh a = 1 + s / R:
//   F = 2 pi eps0 U^2 sum_n (coth a - n coth n a) / sinh n a, here turned to an attraction.
// 2 % at a hundredth of the radius; the next term of F s / R goes with s/R ln(s/R).
TEST(contact_potential, is_the_leading_term_of_the_exact_force_of_a_sphere_above_a_plane) {
  const double r = 1e-4;
  ContactPotential law;
  law.potential = 0.3;
  law.greatest_gap = r;
  double last = 1.0;
  for (const double gap : {1e-2 * r, 1e-3 * r, 1e-4 * r}) {
    const double a = std::acosh(1.0 + gap / r);
    double sum = 0.0;
    for (int n = 1; n * a < 60.0; ++n)
      sum += (n / std::tanh(n * a) - 1.0 / std::tanh(a)) / std::sinh(n * a);
    const double exact = 2.0 * contact::pi * vacuum_permittivity * 0.09 * sum;
    const double error = std::abs(law.attraction(r, gap) / exact - 1.0);
    EXPECT_LT(error, 0.022) << gap;
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(last, 4e-4);
}

TEST(electrostatic, refuses_what_cannot_be_and_names_all_of_it) {
  EXPECT_EQ(message(Electrostatic{}), "");
  EXPECT_EQ(message(ContactPotential{0.2}), "");
  Electrostatic wrong;
  wrong.medium_permittivity = 8.85e-12;
  wrong.wall_permittivity = 0.5;
  wrong.breakdown_field = 0.0;
  const std::string text = message(wrong);
  for (const char* name : {"permittivity of the medium = 8.85e-12 must be 1 or above",
                           "permittivity of the wall = 0.5", "breakdown field = 0 V/m"})
    EXPECT_NE(text.find(name), std::string::npos) << text;
  Electrostatic charged;
  charged.wall_charge = 1.0;
  EXPECT_NE(message(charged).find("C/m2, not in uC/m2"), std::string::npos);
  EXPECT_NE(message(ContactPotential{0.2, 1.0, 0.0}).find("smallest gap"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain::adhesion
