// Contact durations and depths against closed forms, and against the equations of motion that
// LIGGGHTS's normal models solve, written as its headers have them and integrated finely.
#include "fix_cfd_coupling/dem_physics/contact_time.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "fix_cfd_coupling/dem_physics/contact_step.h"

namespace gasgrain::contact {
namespace {

// Two equal glass spheres of 2.5 mm, softened: the pair of inputs/spouted_bed_small.
constexpr double radius = 0.5 * 1.25e-3;                            // [m]
const double mass = 0.5 * 2500.0 * pi / 6.0 * std::pow(2.5e-3, 3);  // [kg]
const double modulus = effective_modulus(1e7, 0.17, 1e7, 0.17);     // [Pa]
const double hertz_k = hertz_stiffness(modulus, radius);

struct Collision {
  double duration;
  double greatest_overlap;
  double restitution;
};

// Classical Runge-Kutta up to the zero of the overlap, which the last step's chord finds.
template <class Acceleration>
Collision collide(double speed, double step, Acceleration&& a) {
  double x = 0.0;
  double v = speed;
  double t = 0.0;
  double deepest = 0.0;
  while (true) {
    const double v2 = v + 0.5 * step * a(x, v);
    const double x2 = x + 0.5 * step * v;
    const double v3 = v + 0.5 * step * a(x2, v2);
    const double x3 = x + 0.5 * step * v2;
    const double v4 = v + step * a(x3, v3);
    const double x4 = x + step * v3;
    const double x_new = x + step / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    const double v_new = v + step / 6.0 * (a(x, v) + 2.0 * a(x2, v2) + 2.0 * a(x3, v3) + a(x4, v4));
    if (x_new <= 0.0) return {t + step * x / (x - x_new), deepest, -v_new / speed};
    x = x_new;
    v = v_new;
    t += step;
    deepest = std::max(deepest, x);
  }
}

// normal_model_hertz.h, with its names.
Collision collide_hertz(double speed, double restitution) {
  const double log_e = std::log(restitution);
  const double betaeff = log_e / std::sqrt(log_e * log_e + pi * pi);
  const double step = 1e-4 * hertz_greatest_overlap(hertz_k, mass, speed) / speed;
  return collide(speed, step, [&](double delta, double v) {
    const double deltan = std::max(delta, 0.0);
    const double sqrtval = std::sqrt(radius * deltan);
    const double Sn = 2.0 * modulus * sqrtval;
    const double kn = 4.0 / 3.0 * modulus * sqrtval;
    const double gamman = -2.0 * std::sqrt(5.0 / 6.0) * betaeff * std::sqrt(Sn * mass);
    return -(kn * deltan + gamman * v) / mass;
  });
}

// 4/5 sqrt(pi) Gamma(2/5) / Gamma(9/10) = 2.9433: Landau and Lifshitz, problem of paragraph 9.
TEST(contact_time, of_hertz_without_damping_is_2_94_depths_over_speed) {
  const double exact = 0.8 * std::sqrt(pi) * std::tgamma(0.4) / std::tgamma(0.9);
  EXPECT_NEAR(exact, 2.943, 5e-4);
  for (const double speed : {0.01, 0.3, 5.0}) {
    const double depth = hertz_greatest_overlap(hertz_k, mass, speed);
    EXPECT_NEAR(hertz_duration(hertz_k, mass, speed) * speed / (exact * depth), 1.0, 1e-8);
  }
}

// The integration's own error is that of the first steps, where delta^(3/2) has no third
// derivative, and of the chord: 1e-5 with 3e4 steps a contact.
TEST(contact_time, of_damped_hertz_is_that_of_the_hosts_equation_of_motion) {
  for (const double restitution : {1.0, 0.97, 0.9, 0.5, 0.2})
    for (const double speed : {0.02, 2.0}) {
      const Collision met = collide_hertz(speed, restitution);
      EXPECT_NEAR(hertz_duration(hertz_k, mass, speed, restitution) / met.duration, 1.0, 2e-5)
          << "e " << restitution << ", v " << speed;
      EXPECT_NEAR(met.restitution, restitution, 1e-4);
    }
}

TEST(contact_time, the_greatest_overlap_of_hertz_is_that_of_the_equation_of_motion) {
  for (const double speed : {0.02, 2.0})
    EXPECT_NEAR(
        hertz_greatest_overlap(hertz_k, mass, speed) / collide_hertz(speed, 1.0).greatest_overlap,
        1.0, 1e-6);
}

TEST(contact_time, of_hertz_goes_with_the_modulus_to_the_minus_two_fifths_and_weakly_with_speed) {
  const double t = hertz_duration(hertz_k, mass, 1.0, 0.9);
  EXPECT_NEAR(hertz_duration(32.0 * hertz_k, mass, 1.0, 0.9) / t, 0.25, 1e-12);
  EXPECT_NEAR(hertz_duration(hertz_k, mass, 32.0, 0.9) / t, 0.5, 1e-12);
  EXPECT_NEAR(hertz_duration(hertz_k, 32.0 * mass, 1.0, 0.9) / t, 4.0, 1e-12);
}

TEST(contact_time, of_a_spring_and_dashpot_is_half_a_damped_period) {
  const double k = 1000.0;
  EXPECT_NEAR(linear_duration(k, mass) / (pi * std::sqrt(mass / k)), 1.0, 1e-14);
  for (const double restitution : {0.9, 0.5, 0.1}) {
    const double log_e = std::log(restitution);
    // normal_model_hooke.h
    const double gamman = std::sqrt(4.0 * mass * k * log_e * log_e / (log_e * log_e + pi * pi));
    const double step = 1e-4 * std::sqrt(mass / k);
    const Collision met =
        collide(1.0, step, [&](double x, double v) { return -(k * x + gamman * v) / mass; });
    EXPECT_NEAR(linear_duration(k, mass, restitution) / met.duration, 1.0, 1e-6);
    EXPECT_NEAR(linear_duration_of_dashpot(k, mass, gamman) / met.duration, 1.0, 1e-6);
    EXPECT_NEAR(met.restitution, restitution, 1e-4);
  }
  EXPECT_TRUE(std::isinf(linear_duration_of_dashpot(k, mass, 2.1 * std::sqrt(k * mass))));
}

// What the stiffness of `hooke` is made for: at the characteristic velocity the spring is pressed
// as deep as Hertz's contact.
TEST(contact_time, hookes_stiffness_gives_hertzs_depth_at_the_characteristic_velocity) {
  for (const double v : {0.1, 2.0}) {
    const double k = hooke_stiffness(modulus, radius, mass, v);
    EXPECT_NEAR(linear_greatest_overlap(k, mass, v) / hertz_greatest_overlap(hertz_k, mass, v), 1.0,
                1e-12);
    // normal_model_hooke.h, kn, worked out in another order
    const double same =
        std::pow(16.0 / 15.0 * std::sqrt(radius) * modulus, 0.8) * std::pow(mass * v * v, 0.2);
    EXPECT_NEAR(k / same, 1.0, 1e-12);
  }
}

TEST(contact_time, the_tangent_stiffness_is_the_derivative_of_the_force) {
  const double delta = 1e-5;
  const double h = 1e-9;
  const auto force = [](double x) { return hertz_k * std::pow(x, 1.5); };
  const double slope = (force(delta + h) - force(delta - h)) / (2.0 * h);
  EXPECT_NEAR(hertz_tangent_stiffness(hertz_k, delta) / slope, 1.0, 1e-6);
}

TEST(contact_time, moduli_and_masses_of_two_equal_spheres_are_half_of_one) {
  EXPECT_DOUBLE_EQ(effective(3.0, 3.0), 1.5);
  EXPECT_NEAR(effective(3.0, 1e30), 3.0, 1e-12);  // a wall
  EXPECT_NEAR(effective_modulus(7e10, 0.2, 7e10, 0.2), 7e10 / (2.0 * (1.0 - 0.04)), 1e-3);
  EXPECT_NEAR(shear_modulus(7e10, 0.25), 2.8e10, 1e-3);
}

// Glass, 2.5 mm: the wave of about 3.2 km/s needs 1.2 us for half the circumference.
TEST(contact_time, rayleighs_wave_runs_over_a_glass_sphere_in_a_microsecond) {
  const double shear = shear_modulus(7e10, 0.23);
  const double t = rayleigh_time(1.25e-3, 2500.0, shear, 0.23);
  const double wave_speed = (0.1631 * 0.23 + 0.8766) * std::sqrt(shear / 2500.0);
  EXPECT_NEAR(t, pi * 1.25e-3 / wave_speed, 1e-15);
  EXPECT_GT(t, 1.1e-6);
  EXPECT_LT(t, 1.4e-6);
}

// velocity Verlet with the force of the half-step velocity, as the host has it; `phase`: where in
// the step the contact begins.
double verlet_restitution(double share, double restitution, double phase) {
  const double zeta = damping_ratio(restitution);
  const double k = 1000.0;
  const double dt = share * linear_duration(k, mass, restitution);
  const auto a = [&](double x, double v) {
    return x > 0.0 ? -(k * x + 2.0 * zeta * std::sqrt(mass * k) * v) / mass : 0.0;
  };
  double x = -phase * dt;
  double v = 1.0;
  double now = 0.0;
  while (x > 0.0 || v > 0.0) {
    const double half = v + 0.5 * dt * now;
    x += dt * half;
    now = a(x, half);
    v = half + 0.5 * dt * now;
  }
  return -v;
}

// The figures of contact_step.h, of hooke at e = 0.97.
TEST(contact_step, the_restitution_of_a_step_is_as_good_as_its_share_of_the_contact) {
  const auto spread = [](double share) {
    double least = 2.0;
    double greatest = 0.0;
    for (int n = 0; n < 40; ++n) {
      const double met = verlet_restitution(share, 0.97, (n + 0.5) / 40.0);
      least = std::min(least, met);
      greatest = std::max(greatest, met);
    }
    return std::pair{least, greatest};
  };
  EXPECT_GT(spread(advised_share).first, 0.969);
  EXPECT_LT(spread(advised_share).second, 0.9735);
  EXPECT_GT(spread(resolved_share).first, 0.966);
  EXPECT_LT(spread(resolved_share).second, 0.978);
  EXPECT_GT(spread(2.0 * resolved_share).second, 0.99);
}

// omega dt = 2 in the stiffest motion of a close packing, which is twice that of a pair.
TEST(contact_step, the_stable_share_is_verlets_limit_in_a_close_packing) {
  const double k = 1000.0;
  const double pair = std::sqrt(k / mass);
  EXPECT_NEAR(2.0 / (2.0 * pair) / linear_duration(k, mass), stable_share, 1e-3);
}

TEST(contact_step, a_step_to_write_has_two_digits_and_is_not_above) {
  EXPECT_NEAR(two_digits_below(1.6789e-5), 1.6e-5, 1e-18);
  EXPECT_NEAR(two_digits_below(1.0e-5), 1.0e-5, 1e-18);
  EXPECT_NEAR(two_digits_below(9.99e-4), 9.9e-4, 1e-16);
}

}  // namespace
}  // namespace gasgrain::contact
