// The collisional exchange where its formulas divide by nothing: close packing, equal velocities,
// cells of one parcel, of none, of droplets, of dry solids.
#include <gtest/gtest.h>

#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Stepped {
  ExchangeReport report;
  ExchangeCells cells;
};

Stepped step(Parcels& parcels, const ExchangeSettings& settings, double dt, int cells = 1) {
  CollisionalExchange exchange(settings);
  const ExchangeReport report =
      exchange.step(parcels.view(), row_of_cells(cells), cell_volume, dt, on_one_rank);
  for (const auto* values : {&parcels.film_mass, &parcels.velocity, &parcels.film_temperature})
    for (const double value : *values) EXPECT_TRUE(std::isfinite(value));
  return {report, exchange.cells()};
}

void expect_equilibrium(const Parcels& parcels, const ExchangeCells& cells, bool warm) {
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    const std::uint32_t c = parcels.cell[p];
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_EQ(parcels.velocity[3 * p + d], cells.equilibrium_velocity[d][c]);
    for (std::size_t i = 0; i < parcels.species; ++i) {
      const double film = cells.species_ratio[i][c] * parcels.solid_mass[p];
      EXPECT_NEAR(parcels.film_mass[p * parcels.species + i], film, 1e-15 * film);
    }
    // Newton's last pass leaves a rounding or two.
    if (warm) {
      EXPECT_NEAR(parcels.film_temperature[p], cells.film_temperature[c], 1e-12);
    }
  }
}

TEST(exchange_limits, at_close_packing_and_beyond_one_step_reaches_equilibrium) {
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance})
    for (const double fraction : {0.58, 0.7, 1.0, 2.0}) {
      ExchangeSettings settings = settings_of(3, true);
      settings.agglomeration = agglomeration;
      // Exactly so: the packing is set by the volume of the cell's parcels.
      Parcels parcels = random_parcels(1, 30, 3, 3);
      double solids = 0.0;
      for (std::size_t p = 0; p < parcels.count(); ++p)
        solids += parcels.particles[p] * parcels.solid_volume[p] / cell_volume;
      for (double& n : parcels.particles) n *= fraction * (1.0 + 1e-12) / solids;
      const Stepped s = step(parcels, settings, 1e-9);
      EXPECT_EQ(s.cells.collision_time[0], 0.0) << fraction;
      EXPECT_EQ(s.report.at_close_packing, parcels.count());
      expect_equilibrium(parcels, s.cells, true);
    }
}

TEST(exchange_limits, collision_time_vanishes_steadily_towards_close_packing) {
  // No jump: a thousandth below close packing tau is a thousandth of what it is half way.
  double half_way = 0.0;
  for (const double gap : {0.5, 1e-3, 1e-6, 1e-9}) {
    Parcels parcels = random_parcels(1, 30, 0, 3);
    double solids = 0.0;
    for (std::size_t p = 0; p < parcels.count(); ++p)
      solids += parcels.particles[p] * parcels.solid_volume[p] / cell_volume;
    for (double& n : parcels.particles) n *= 0.58 * (1.0 - gap) / solids;
    const double tau = step(parcels, settings_of(0), 1e-6).cells.collision_time[0];
    if (gap == 0.5) half_way = tau;
    EXPECT_NEAR(tau / half_way, gap / (1.0 - gap), 1e-6 * gap / (1.0 - gap));
  }
}

TEST(exchange_limits, a_block_that_moves_as_one_exchanges_nothing_at_any_packing) {
  for (const double fraction : {0.2, 0.58, 0.9})
    for (const Vec3& u : {Vec3(0, 0, 0), Vec3(0.1, -0.3, 1e3), Vec3(1.0 / 3.0, 0, 1e-7)}) {
      Parcels parcels = random_parcels(4, 100, 2, 3, fraction);
      for (std::size_t p = 0; p < parcels.count(); ++p)
        for (int d = 0; d < 3; ++d) parcels.velocity[3 * p + d] = u[d];
      const Parcels before = parcels;
      const Stepped s = step(parcels, settings_of(2, true), 1.0, 4);
      EXPECT_EQ(parcels.velocity, before.velocity);
      EXPECT_EQ(parcels.film_mass, before.film_mass);
      EXPECT_EQ(parcels.film_temperature, before.film_temperature);
      EXPECT_EQ(s.report.at_close_packing, 0U);
      EXPECT_EQ(s.report.liquid_moved, 0.0);
      EXPECT_EQ(s.cells.collision_time[0], infinite);
    }
}

TEST(exchange_limits, a_parcel_alone_keeps_all_that_it_has_even_in_a_full_cell) {
  for (const double n : {1.0, 1.1e6, 1e9}) {  // 5e-13 m3 each: theta_s to beyond 1
    Parcels parcels;
    parcels.species = 2;
    parcels.add(1, n, 1.1e-9, 5e-13, {1e-10, 3e-11}, {0.3, -1.7, 11.0}, 333.0);
    const Parcels before = parcels;
    const Stepped s = step(parcels, settings_of(2, true), 1e3, 3);
    EXPECT_EQ(parcels.velocity, before.velocity);
    EXPECT_EQ(parcels.film_mass, before.film_mass);
    EXPECT_EQ(parcels.film_temperature, before.film_temperature);
    EXPECT_EQ(s.report.parcels, 1U);
  }
}

TEST(exchange_limits, cells_without_parcels_are_zero_and_know_no_collisions) {
  Parcels parcels;
  parcels.species = 1;
  const Stepped none = step(parcels, settings_of(1, true), 1.0, 2);
  EXPECT_EQ(none.report.parcels, 0U);
  parcels.add(1, 10.0, 1e-9, 5e-13, {1e-10}, {1, 0, 0});
  const Stepped one = step(parcels, settings_of(1, true), 1.0, 2);
  for (const ExchangeCells& cells : {none.cells, one.cells}) {
    EXPECT_EQ(cells.collision_time[0], infinite);
    for (const double value :
         {cells.solid_mass[0], cells.rms_velocity[0], cells.particle_fraction[0],
          cells.sauter_radius[0], cells.liquid_ratio[0], cells.film_temperature[0],
          cells.equilibrium_velocity[0][0], cells.close_packing[0]})
      EXPECT_EQ(value, 0.0);
  }
  EXPECT_GT(one.cells.solid_mass[1], 0.0);
}

TEST(exchange_limits, a_parcel_of_no_cell_takes_no_part) {
  Parcels parcels = random_parcels(1, 10, 1, 3);
  Parcels without = parcels;
  parcels.add(no_cell, 1e6, 1e-9, 5e-13, {1e-10}, {100, 0, 0});
  const ExchangeReport report = step(parcels, settings_of(1), 1e-3).report;
  step(without, settings_of(1), 1e-3);
  EXPECT_EQ(report.parcels, without.count());
  EXPECT_EQ(parcels.velocity[30], 100.0);
  EXPECT_EQ(parcels.film_mass[10], 1e-10);
  EXPECT_TRUE(
      std::equal(without.velocity.begin(), without.velocity.end(), parcels.velocity.begin()));
}

TEST(exchange_limits, droplets_on_equal_vanishing_cores_become_equal) {
  // Cores of 1e-10 m: lambda about 1e17; (55) with M_s lambda still shares the liquid out.
  ExchangeSettings settings = settings_of(1);
  Parcels parcels;
  parcels.species = 1;
  double liquid = 0.0;
  for (int k = 0; k < 20; ++k) {
    parcels.add(0, 1.0 + k, 4e-27, 4.2e-30, {1e-10 * (1 + k)}, {k % 3 * 1.0, 0, 0});
    liquid += (1.0 + k) * 1e-10 * (1 + k);
  }
  const Stepped s = step(parcels, settings, 1e12);
  EXPECT_GT(s.cells.liquid_ratio[0], 1e16);
  EXPECT_EQ(s.cells.close_packing[0], 1.0);  // drops may fill the cell
  // 1e12 s are 1e3 times what tau_t would need for the last digit.
  for (std::size_t p = 0; p < parcels.count(); ++p)
    EXPECT_NEAR(parcels.film_mass[p], liquid / 210.0, 1e-5 * liquid / 210.0);
  EXPECT_EQ(s.report.films_without_solid, 0U);
}

TEST(exchange_limits, droplets_alone_relax_with_the_rate_of_pure_liquid) {
  // One step of velocities: (59) with K of (61) at lambda infinite.
  ExchangeSettings settings = settings_of(1);
  Parcels parcels;
  parcels.species = 1;
  for (const double u : {-1.0, 1.0}) parcels.add(0, 1e5, 4e-27, 4.2e-30, {1e-9}, {u, 0, 0});
  const double volume = 1e-9 / 998.0;
  const double theta = 2e5 * volume / cell_volume;
  const double radius = std::cbrt(volume * 3.0 / (4.0 * 3.14159265358979323846));
  const double tau = 1.0 / (1.0 / radius * theta / (1.0 - theta));
  const Stepped s = step(parcels, settings, 3.0 * tau);
  EXPECT_NEAR(s.cells.collision_time[0], tau, 1e-12 * tau);
  EXPECT_NEAR(parcels.velocity[3], 1.0 / (1.0 + 3.0 * settings.k_liquid), 1e-12);
}

TEST(exchange_limits, liquid_without_any_solid_mass_keeps_its_films_and_is_told) {
  Parcels parcels;
  parcels.species = 1;
  for (int k = 0; k < 5; ++k) parcels.add(0, 1e3, 0.0, 0.0, {1e-9 * (1 + k)}, {k * 1.0, 0, 0});
  const Parcels before = parcels;
  const Stepped s = step(parcels, settings_of(1, true), 1.0);
  EXPECT_EQ(parcels.film_mass, before.film_mass);
  EXPECT_NE(parcels.velocity, before.velocity);
  EXPECT_EQ(s.report.films_without_solid, 5U);
}

TEST(exchange_limits, a_droplet_without_core_gives_all_its_liquid_to_the_solids_around) {
  Parcels parcels = random_parcels(1, 20, 1, 3, 0.8);
  parcels.add(0, 1e3, 0.0, 0.0, {1e-9}, {9, 9, 9});
  const Stepped s = step(parcels, settings_of(1), 1e-3);
  EXPECT_EQ(parcels.film_mass.back(), 0.0);
  expect_equilibrium(parcels, s.cells, false);
}

TEST(exchange_limits, dry_particles_exchange_velocities_alone) {
  for (const std::size_t species : {0U, 2U}) {
    Parcels parcels = random_parcels(1, 20, 0, 3);
    parcels.species = species;
    parcels.film_mass.assign(20 * species, 0.0);
    const Parcels before = parcels;
    const Stepped s = step(parcels, settings_of(species, species > 0), 1e-2);
    EXPECT_EQ(parcels.film_mass, before.film_mass);
    EXPECT_EQ(parcels.film_temperature, before.film_temperature);
    EXPECT_NE(parcels.velocity, before.velocity);
    EXPECT_EQ(s.report.liquid_moved, 0.0);
    EXPECT_EQ(s.cells.liquid_ratio[0], 0.0);
  }
}

TEST(exchange_limits, a_film_of_no_mass_takes_the_equilibrium_temperature_with_its_first_liquid) {
  Parcels parcels;
  parcels.species = 1;
  parcels.add(0, 1e4, 1e-9, 5e-13, {1e-10}, {1, 0, 0}, 350.0);
  parcels.add(0, 1e4, 1e-9, 5e-13, {0.0}, {0, 0, 0}, 12345.0);
  const Stepped s = step(parcels, settings_of(1, true), 1e-3);
  EXPECT_NEAR(s.cells.film_temperature[0], 350.0, 1e-10);
  EXPECT_EQ(parcels.film_temperature[1], s.cells.film_temperature[0]);
  EXPECT_GT(parcels.film_mass[1], 0.0);
  EXPECT_EQ(s.report.temperatures_beyond_range, 0U);
}

TEST(exchange_limits, negative_films_are_counted) {
  Parcels parcels = random_parcels(1, 20, 2, 3);
  parcels.film_mass[7] = -1e-14;
  EXPECT_EQ(step(parcels, settings_of(2), 1e-6).report.films_below_zero, 1U);
}

TEST(exchange_limits, without_a_rate_constant_nothing_is_exchanged_even_at_close_packing) {
  ExchangeSettings settings = settings_of(1);
  settings.k_solid = settings.k_liquid = 0.0;
  Parcels parcels = random_parcels(1, 20, 1, 3, 0.8);
  const Parcels before = parcels;
  step(parcels, settings, 1.0);
  EXPECT_EQ(parcels.velocity, before.velocity);
  EXPECT_EQ(parcels.film_mass, before.film_mass);
}

TEST(exchange_limits, a_step_of_no_time_changes_nothing_below_close_packing) {
  Parcels parcels = random_parcels(1, 20, 1, 3);
  const Parcels before = parcels;
  step(parcels, settings_of(1), 0.0);
  EXPECT_EQ(parcels.velocity, before.velocity);
  EXPECT_EQ(parcels.film_mass, before.film_mass);
}

}  // namespace
}  // namespace gasgrain
