// Sintered necks: growth against a numerical integration of its rate, strength, and the correction
// of the contact time against collisions integrated step by step.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "fix_cfd_coupling/dem_physics/adhesion/neck_contact_time.h"
#include "fix_cfd_coupling/dem_physics/adhesion/neck_strength.h"
#include "fix_cfd_coupling/dem_physics/adhesion/sintered_neck.h"
#include "tests/refusal.h"

namespace gasgrain::adhesion {
namespace {

// Figures of iron's order.
Sintering iron(int micro_contacts = 1) {
  Sintering law;
  law.surface_tension = 1.72;
  law.lattice_constant = 2.87e-10;
  law.surface = {5.2e-4, 2.21e5};
  law.volume = {1.8e-5, 2.7e5};
  law.micro_contacts = micro_contacts;
  return law;
}
constexpr double grain = 1e-4;   // [m]
constexpr double cold = 1150.0;  // [K], surface diffusion
constexpr double hot = 1400.0;   // [K], volume diffusion

TEST(sintered_neck, grows_with_the_seventh_root_of_time_by_surface_diffusion) {
  const Sintering law = iron();
  const double one = law.grown(0.0, grain, cold, 1e-3);
  const double d = 5.2e-4 * std::exp(-2.21e5 / (8.31446262 * cold));
  const double closed =
      56.0 * 1.72 * std::pow(2.87e-10, 4) / (1.380649e-23 * cold) * d * std::pow(grain, 3) * 1e-3;
  EXPECT_NEAR(one / std::pow(closed, 1.0 / 7.0), 1.0, 1e-12);
  EXPECT_NEAR(law.grown(0.0, grain, cold, 128e-3) / one, 2.0, 1e-12);
}

TEST(sintered_neck, grows_with_the_fifth_root_of_time_by_volume_diffusion) {
  const Sintering law = iron();
  const double one = law.grown(0.0, grain, hot, 1e-3);
  const double d = 1.8e-5 * std::exp(-2.7e5 / (8.31446262 * hot));
  const double closed =
      10.0 * 1.72 * std::pow(2.87e-10, 3) / (1.380649e-23 * hot) * d * std::pow(grain, 2) * 1e-3;
  EXPECT_NEAR(one / std::pow(closed, 1.0 / 5.0), 1.0, 1e-12);
  EXPECT_NEAR(law.grown(0.0, grain, hot, 32e-3) / one, 2.0, 1e-12);
}

// Runge-Kutta over dx/dt = B / (n x^(n-1)), begun from a neck; 1000 steps double the neck's power
// many times over, and the error of fourth order is below 1e-8.
TEST(sintered_neck, growth_from_a_neck_is_the_integral_of_its_rate) {
  const Sintering law = iron();
  for (const double temperature : {cold, hot}) {
    const double n = law.exponent(temperature);
    const double rate = law.rate(grain, temperature);
    const double begin = law.grown(0.0, grain, temperature, 1e-3);
    const auto slope = [&](double x) { return rate / (n * std::pow(x, n - 1.0)); };
    const double dt = 1e-5;
    double x = begin;
    for (int step = 0; step < 1000; ++step) {
      const double k1 = slope(x);
      const double k2 = slope(x + 0.5 * dt * k1);
      const double k3 = slope(x + 0.5 * dt * k2);
      const double k4 = slope(x + dt * k3);
      x += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    EXPECT_NEAR(law.grown(begin, grain, temperature, 1e-2) / x, 1.0, 1e-8);
    EXPECT_GT(x / begin, 1.3);
  }
}

// Round-off of 1e-16 a step, divided by n.
TEST(sintered_neck, growth_does_not_depend_on_how_it_is_cut_into_steps) {
  const Sintering law = iron();
  double x = 0.0;
  for (int step = 0; step < 10000; ++step) x = law.grown(x, grain, cold, 1e-6);
  EXPECT_NEAR(x / law.grown(0.0, grain, cold, 1e-2), 1.0, 1e-11);
}

TEST(sintered_neck, goes_on_growing_without_a_jump_where_the_mechanism_changes) {
  const Sintering law = iron();
  const double cool = law.grown(0.0, grain, 1323.0, 1e-3);
  EXPECT_FALSE(law.by_volume(1323.0));
  EXPECT_TRUE(law.by_volume(1323.15));
  EXPECT_NEAR(law.grown(cool, grain, 1323.15, 1e-15) / cool, 1.0, 1e-6);
  EXPECT_GT(law.grown(cool, grain, 1323.15, 1e-3), cool);
}

// Eqs 5.94 to 5.96: n necks of a sub-grain a tenth as large: x falls by 10^(3/7).
TEST(sintered_neck, of_rough_grains_has_three_or_nine_necks_of_sub_grains_of_a_tenth) {
  const double smooth = iron(1).grown(0.0, grain, cold, 1e-2);
  for (const int n : {3, 9}) {
    const Sintering law = iron(n);
    const double rough = law.grown(0.0, grain, cold, 1e-2);
    EXPECT_NEAR(rough / smooth, std::pow(10.0, -3.0 / 7.0), 1e-12);
    EXPECT_NEAR(law.area(rough) / iron(1).area(smooth), n * std::pow(10.0, -6.0 / 7.0), 1e-12);
  }
}

TEST(sintered_neck,
     of_a_wall_is_that_of_a_sphere_of_infinite_radius_and_of_like_spheres_their_own) {
  EXPECT_NEAR(grain_radius_of_pair(grain, grain) / grain, 1.0, 1e-14);
  EXPECT_NEAR(grain_radius_of_pair(grain, 1e12) / grain_radius_at_wall(grain), 1.0, 1e-12);
}

TEST(sintered_neck, without_tension_diffusion_or_time_stays_bit_for_bit) {
  Sintering off = iron();
  off.surface_tension = 0.0;
  EXPECT_EQ(off.grown(0.0, grain, cold, 1.0), 0.0);
  EXPECT_EQ(off.grown(1.23e-6, grain, cold, 1.0), 1.23e-6);
  EXPECT_EQ(iron().grown(1.23e-6, grain, cold, 0.0), 1.23e-6);
  Sintering still = iron();
  still.surface.prefactor = 0.0;
  EXPECT_EQ(still.grown(1.23e-6, grain, cold, 1.0), 1.23e-6);
}

TEST(sintered_neck, is_finite_from_room_temperature_to_melting_and_says_when_it_left_its_range) {
  for (const int n : {1, 3, 9})
    for (const double temperature : {293.0, 900.0, 1323.15, 1800.0})
      for (const double time : {1e-9, 1.0, 1e6}) {
        const double x = iron(n).grown(0.0, grain, temperature, time);
        EXPECT_TRUE(std::isfinite(x));
        EXPECT_GT(x, 0.0);
      }
  EXPECT_FALSE(iron().beyond_first_stage(0.29 * grain, grain));
  EXPECT_TRUE(iron().beyond_first_stage(0.31 * grain, grain));
  EXPECT_TRUE(iron(3).beyond_first_stage(0.031 * grain, grain));
}

TEST(neck_strength, breaks_at_the_tensile_or_the_shear_strength_of_all_necks) {
  const NeckStrength strength{2e7, 1e7};
  const double area = iron(3).area(1e-6);
  EXPECT_NEAR(area, 3.0 * contact::pi * 1e-12, 1e-25);
  const double pull = 2e7 * area;
  const double shear = 1e7 * area;
  EXPECT_TRUE(strength.holds(0.999 * pull, 0.999 * shear, area));
  EXPECT_FALSE(strength.holds(pull, 0.0, area));
  EXPECT_FALSE(strength.holds(0.0, shear, area));
  EXPECT_FALSE(strength.holds(0.0, -shear, area));
  EXPECT_TRUE(strength.holds(-100.0 * pull, 0.0, area));  // pressed together
  EXPECT_FALSE(strength.holds(0.0, 0.0, 0.0));            // no neck
}

TEST(neck_strength, the_pull_begins_at_zero_overlap_and_ends_at_the_breaking_gap) {
  const NeckStrength strength{2e7, 1e7};
  const double area = iron().area(1e-6);
  const double k = 800.0;
  EXPECT_EQ(neck_attraction(k, 0.0), 0.0);
  EXPECT_EQ(neck_attraction(k, -1e-6), 0.0);
  const double gap = breaking_gap(strength, area, k);
  EXPECT_TRUE(strength.holds(neck_attraction(k, 0.9999 * gap), 0.0, area));
  EXPECT_FALSE(strength.holds(neck_attraction(k, 1.0001 * gap), 0.0, area));
}

// A collision of the pair, spring (linear or Hertz's) without damping, by velocity Verlet of 4000
// steps; `each(t, dt)` is called for every step in touch.
template <class Force, class Each>
void collide(double duration, double mass, double speed, const Force& force, const Each& each) {
  const double dt = duration / 4000.0;
  double x = 0.0;
  double v = speed;
  double t = 0.0;
  double a = 0.0;
  do {
    v += 0.5 * dt * a;
    x += dt * v;
    a = -force(std::max(x, 0.0)) / mass;
    v += 0.5 * dt * a;
    each(t, dt);
    t += dt;
  } while (x > 0.0);
}

// The end of a contact is met to one step in 4000, a seventh of it in the neck.
TEST(neck_contact_time, a_softened_linear_contact_grows_the_neck_of_the_real_hertzian_one) {
  const double mass = contact::effective(3.3e-8, 3.3e-8);
  const double reduced = 0.5 * grain;
  const double speed = 0.1;
  const double real_k = contact::hertz_stiffness(1.1e11, reduced);
  const double soft_k = 10.0;  // [N/m]
  const CollisionDurations times{contact::linear_duration(soft_k, mass),
                                 contact::hertz_duration(real_k, mass, speed)};
  ASSERT_GT(times.in_dem / times.real, 20.0);  // the softening is worth a correction
  const Sintering law = iron();
  double real = 0.0;
  collide(
      times.real, mass, speed, [&](double x) { return real_k * x * std::sqrt(x); },
      [&](double, double dt) { real = law.grown(real, grain, cold, dt); });
  double softened = 0.0;
  double uncorrected = 0.0;
  collide(
      times.in_dem, mass, speed, [&](double x) { return soft_k * x; },
      [&](double t, double dt) {
        softened = law.grown(softened, grain, cold, times.growth_between(t, t + dt));
        uncorrected = law.grown(uncorrected, grain, cold, dt);
      });
  EXPECT_NEAR(softened / real, 1.0, 2e-4);
  EXPECT_GT(uncorrected / real, 1.4);  // 20^(1/7)
}

TEST(neck_contact_time, scales_the_collision_and_leaves_rest_as_it_is) {
  const CollisionDurations times{1e-4, 1e-6};
  EXPECT_EQ(times.growth_time(0.0), 0.0);
  EXPECT_NEAR(times.growth_time(5e-5), 5e-7, 1e-19);
  EXPECT_NEAR(times.growth_time(1e-4), 1e-6, 1e-18);
  EXPECT_NEAR(times.growth_time(1.0 + 1e-4), 1.0 + 1e-6, 1e-12);
  const CollisionDurations same{3e-5, 3e-5};
  for (const double t : {1e-9, 1e-5, 2.0}) EXPECT_EQ(same.growth_time(t), t);
}

// The header's word on eq 5.101: 3.218 with the reduced mass, 2.44 with that of one of two equal
// grains.
TEST(neck_contact_time, the_sources_constant_is_hertzs_with_the_mass_of_one_grain) {
  const double m = 3.3e-8;
  const double d = 2.0 * grain;
  const double youngs = 2e11;
  const double nu = 0.3;
  const double xi = youngs * std::sqrt(d) / (3.0 * (1.0 - nu * nu));
  const double k =
      contact::hertz_stiffness(contact::effective_modulus(youngs, nu, youngs, nu), 0.5 * grain);
  EXPECT_NEAR(xi / k, 1.0, 1e-12);
  const double speed = 0.2;
  const double exact = contact::hertz_duration(k, contact::effective(m, m), speed);
  const auto form = [&](double mass) { return std::pow(mass * mass / (xi * xi * speed), 0.2); };
  EXPECT_NEAR(exact / form(0.5 * m), 3.218, 1e-3);
  EXPECT_NEAR(exact / form(m), 2.44, 5e-3);
}

TEST(sintered_neck, refuses_what_cannot_be_and_names_all_of_it) {
  EXPECT_EQ(message(iron()), "");
  Sintering wrong = iron(5);
  wrong.lattice_constant = 0.287;
  wrong.surface_tension = -1.0;
  wrong.surface.activation_energy = -2.0;
  wrong.volume_diffusion_from = std::nan("");
  const std::string text = message(wrong);
  for (const char* name :
       {"micro_contacts = 5 must be 1, 3 or 9", "give it in m, not in nm", "surface tension = -1",
        "activation energy of surface diffusion = -2 J/mol", "volume_diffusion_from = nan K"})
    EXPECT_NE(text.find(name), std::string::npos) << text;
  EXPECT_EQ(message(NeckStrength{1e7, 5e6}), "");
  EXPECT_EQ(message(NeckStrength{}), "");
  EXPECT_NE(message(NeckStrength{1e7, 0.0}).find("give both, or neither"), std::string::npos);
  EXPECT_NE(message(NeckStrength{-1.0, 0.0}).find("tensile strength = -1 Pa"), std::string::npos);
  EXPECT_NE(message(CollisionDurations{0.0, 1.0}).find("duration in the simulation"),
            std::string::npos);
}

}  // namespace
}  // namespace gasgrain::adhesion
