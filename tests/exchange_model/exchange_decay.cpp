// The decay of fluctuations against the analytic solutions: (33) and (35) at constant collision
// times, the ratio (36), the dry solution with the collision time that grows; and the order at
// which the splitting gets there.
//
// Time is counted in collision times: a step is h tau of the cell as it is, so that dt/tau_coll is
// h throughout, as with a constant collision time.
#include <gtest/gtest.h>

#include "tests/exchange_model/exchange_reference.h"

namespace gasgrain {
namespace {

struct Widths {
  double energy;  // sum N_p M_p (u - u_eq)^2
  double liquid;  // sigma_M^2 of (34)
};

Widths widths(const Parcels& parcels, const ExchangeSettings& settings, bool film_has_inertia) {
  const reference::Cell cell = reference::cell_of(parcels, 0, settings, film_has_inertia);
  Widths w{0.0, 0.0};
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    const double n = parcels.particles[p];
    for (int d = 0; d < 3; ++d) {
      const double du = parcels.velocity[3 * p + d] - static_cast<double>(cell.velocity[d]);
      w.energy += n * parcels.inertia(p, film_has_inertia) * du * du;
    }
    const double excess =
        parcels.film(p) - static_cast<double>(cell.liquid_ratio) * parcels.solid_mass[p];
    w.liquid += n * excess * excess;
  }
  return w;
}

// Widths at the end over those at first, after `time` in collision times and steps of h.
Widths decay(Parcels parcels, const ExchangeSettings& settings, double time, int steps,
             bool film_has_inertia) {
  const Widths first = widths(parcels, settings, film_has_inertia);
  CollisionalExchange exchange(settings);
  ExchangeView view = parcels.view();
  view.film_has_inertia = film_has_inertia;
  for (int n = 0; n < steps; ++n) {
    const auto tau =
        static_cast<double>(reference::cell_of(parcels, 0, settings, film_has_inertia).tau);
    exchange.step(view, row_of_cells(1), cell_volume, time / steps * tau, on_one_rank);
  }
  const Widths last = widths(parcels, settings, film_has_inertia);
  return {last.energy / first.energy, last.liquid / first.liquid};
}

ExchangeSettings settings_with(std::size_t species, Agglomeration agglomeration) {
  ExchangeSettings settings = settings_of(species);
  settings.agglomeration = agglomeration;
  return settings;
}

// Films of many masses, all of one speed relative to the mean: no correlation of both. Each film
// has both signs of each velocity, so that the mean velocity is 0.
Parcels films_of_one_speed() {
  Parcels parcels;
  parcels.species = 1;
  for (const double film : {0.0, 1e-10, 4e-10, 9e-10})
    for (int d = 0; d < 3; ++d)
      for (const double sign : {-1.0, 1.0}) {
        Vec3 u = Vec3::Zero();
        u[d] = sign;
        parcels.add(0, 3e4, 1e-9, 5e-13, {film}, u);
      }
  return parcels;
}

// Rates in 1 / tau_coll of u'_rms^2 and sigma_M^2 as dt -> 0: those of (33) and (35), or twice.
Widths rates(const Parcels& parcels, const ExchangeSettings& settings) {
  const reference::Cell cell = reference::cell_of(parcels, 0, settings);
  const double factor = settings.agglomeration == Agglomeration::mean ? 2.0 : 1.0;
  return {factor * static_cast<double>(cell.k_u + cell.k_t),
          factor * static_cast<double>(cell.k_t)};
}

// What the liquid's move does to the energy beside (33): M_p (u - u_eq) decays at one rate for all,
// so that the energy has the factor sum (M u'_0)^2 / M(t) over its value at first, in which M(t)
// goes to its equilibrium at half the rate of sigma_M^2. All u'_0 are 1 here.
double factor_of_moved_liquid(const Parcels& parcels, double liquid_exponent) {
  const reference::Cell cell = reference::cell_of(parcels, 0, settings_of(1));
  const double kept = std::exp(-0.5 * liquid_exponent);
  double first = 0.0;
  double last = 0.0;
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    const double mass = parcels.inertia(p);
    const double equilibrium =
        parcels.solid_mass[p] * (1.0 + static_cast<double>(cell.liquid_ratio));
    first += mass;
    last += mass * mass / (equilibrium + kept * (mass - equilibrium));
  }
  return last / first;
}

TEST(exchange_decay,
     energy_and_liquid_decay_as_33_and_35_with_variances_and_twice_as_fast_with_means) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance}) {
    const ExchangeSettings settings = settings_with(1, agglomeration);
    const Parcels parcels = films_of_one_speed();
    const Widths rate = rates(parcels, settings);
    constexpr double time = 60.0;
    for (const int steps : {200, 400}) {
      const Widths is = decay(parcels, settings, time, steps, true);
      // First order: the relative error of an exponential is (rate time)^2 / steps, at most.
      const double x_u = rate.energy * time;
      const double x_t = rate.liquid * time;
      const double energy = std::exp(-x_u) * factor_of_moved_liquid(parcels, x_t);
      EXPECT_NEAR(is.energy / energy, 1.0, x_u * x_u / steps);
      EXPECT_NEAR(is.liquid / std::exp(-x_t), 1.0, x_t * x_t / steps);
    }
  }
}

// Exponents of the limit dt -> 0, of grains whose mass does not change, by Richardson's
// extrapolation of two first-order results.
Widths exponents(const Parcels& parcels, const ExchangeSettings& settings, double time, int steps) {
  const Widths a = decay(parcels, settings, time, steps, false);
  const Widths b = decay(parcels, settings, time, 2 * steps, false);
  return {std::log(a.energy) - 2.0 * std::log(b.energy),
          std::log(a.liquid) - 2.0 * std::log(b.liquid)};
}

TEST(exchange_decay, time_scales_of_films_and_velocities_have_the_ratio_R) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance})
    for (const double ratio : {1.0, 2.0, 4.0, 50.0}) {
      ExchangeSettings settings = settings_with(1, agglomeration);
      settings.time_scale_ratio = ratio;
      const Widths x = exponents(films_of_one_speed(), settings, 20.0, 200);
      EXPECT_NEAR(x.energy / x.liquid, ratio, 1e-4 * ratio);  // second order remains: (x/200)^2
    }
}

TEST(exchange_decay, the_splitting_converges_with_the_first_order_of_the_step) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance}) {
    const ExchangeSettings settings = settings_with(1, agglomeration);
    const Parcels parcels = films_of_one_speed();
    const Widths rate = rates(parcels, settings);
    constexpr double time = 30.0;
    const double moved = factor_of_moved_liquid(parcels, rate.liquid * time);
    double energy_before = 0.0;
    double liquid_before = 0.0;
    for (const int steps : {50, 100, 200, 400}) {
      const Widths is = decay(parcels, settings, time, steps, true);
      const double energy = is.energy - moved * std::exp(-rate.energy * time);
      const double liquid = is.liquid - std::exp(-rate.liquid * time);
      if (steps > 50) {
        EXPECT_NEAR(std::log2(energy_before / energy), 1.0, 0.05);
        EXPECT_NEAR(std::log2(liquid_before / liquid), 1.0, 0.05);
      }
      energy_before = energy;
      liquid_before = liquid;
    }
  }
}

TEST(exchange_decay,
     dry_or_without_inertia_of_films_the_energy_of_any_cloud_decays_by_psi_each_step) {
  // Then M_p does not change, and the decay of a step is exact: psi_n, or its square with means.
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance})
    for (const std::size_t species : {0U, 2U}) {
      const ExchangeSettings settings = settings_with(species, agglomeration);
      const Parcels parcels = random_parcels(1, 50, species, 31);
      const reference::Cell cell = reference::cell_of(parcels, 0, settings, false);
      const double h = 7.0;
      const double psi = 1.0 / (1.0 + h * static_cast<double>(cell.k_u + cell.k_t));
      const double expected = agglomeration == Agglomeration::mean ? psi * psi : psi;
      const Widths is = decay(parcels, settings, h, 1, false);
      EXPECT_NEAR(is.energy, expected, 1e-12 * expected);
    }
}

TEST(exchange_decay, the_width_of_the_liquid_decays_by_psi_each_step_in_any_cloud) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance}) {
    const ExchangeSettings settings = settings_with(1, agglomeration);
    const Parcels parcels = random_parcels(1, 50, 1, 32);
    const reference::Cell cell = reference::cell_of(parcels, 0, settings);
    const double psi = 1.0 / (1.0 + 20.0 * static_cast<double>(cell.k_t));
    const double expected = agglomeration == Agglomeration::mean ? psi * psi : psi;
    EXPECT_NEAR(decay(parcels, settings, 20.0, 1, true).liquid, expected, 1e-12 * expected);
  }
}

// Dry velocities with the collision time that grows as they decay: du'/dt = -f C K u'^2 with
// 1/tau = C u', K = K_u + K_t, f = 1 with means, 1/2 with variances: u' = u'_0 / (1 + f C K u'_0
// t).
struct Hyperbola {
  double is;
  double expected;
};

Hyperbola dry_decay(Agglomeration agglomeration, int steps) {
  const ExchangeSettings settings = settings_with(0, agglomeration);
  Parcels parcels = random_parcels(1, 50, 0, 33);
  const reference::Cell cell = reference::cell_of(parcels, 0, settings);
  const double f = agglomeration == Agglomeration::mean ? 1.0 : 0.5;
  const double time = 200.0 * static_cast<double>(cell.tau);
  CollisionalExchange exchange(settings);
  for (int n = 0; n < steps; ++n)
    exchange.step(parcels.view(), row_of_cells(1), cell_volume, time / steps, on_one_rank);
  return {static_cast<double>(reference::cell_of(parcels, 0, settings).rms),
          static_cast<double>(cell.rms / (1 + f * (cell.k_u + cell.k_t) / cell.tau * time))};
}

TEST(exchange_decay, of_dry_velocities_by_means_is_exact_with_any_step_while_collisions_die_out) {
  // psi_n = 1 / (1 + C K u'_n dt) is that solution over the step.
  for (const int steps : {1, 7, 100}) {
    const Hyperbola u = dry_decay(Agglomeration::mean, steps);
    EXPECT_NEAR(u.is, u.expected, 1e-12 * u.expected);
  }
}

TEST(exchange_decay, of_dry_velocities_by_variances_is_of_first_order_while_collisions_die_out) {
  double before = 0.0;
  for (const int steps : {50, 100, 200}) {
    const Hyperbola u = dry_decay(Agglomeration::variance, steps);
    const double error = u.is - u.expected;
    if (steps > 50) {
      EXPECT_NEAR(std::log2(before / error), 1.0, 0.1);
    }
    before = error;
  }
}

TEST(exchange_decay, a_single_long_step_reaches_the_full_equilibrium) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance}) {
    const Widths is =
        decay(random_parcels(1, 50, 1, 34), settings_with(1, agglomeration), 1e13, 1, true);
    // Variances: of a droplet without liquid (psi)^(1/2) of its mass and speed, psi about 1e-11.
    EXPECT_LT(is.energy, 1e-6);
    EXPECT_LT(is.liquid, 1e-10);
  }
}

}  // namespace
}  // namespace gasgrain
