// Enthalpies of species, the temperature of a mixture, and films that exchange heat.
#include <gtest/gtest.h>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/film_temperature.h"
#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

const SpeciesEnthalpy cubic{{900.0, 2.0, -0.003, 1e-5}, 250.0, 400.0};

TEST(species_enthalpy, its_slope_is_the_specific_heat_within_the_range_and_beyond) {
  for (const double T : {100.0, 251.0, 300.0, 399.0, 500.0, 2000.0}) {
    constexpr double dT = 1e-2;
    const double slope = (cubic.enthalpy(T + dT) - cubic.enthalpy(T - dT)) / (2.0 * dT);
    EXPECT_NEAR(slope, cubic.specific_heat(T), 1e-6 * slope);  // of the difference: h / dT rounds
  }
}

TEST(species_enthalpy, beyond_its_range_the_specific_heat_stays_and_enthalpy_has_no_jump) {
  EXPECT_EQ(cubic.specific_heat(100.0), cubic.specific_heat(250.0));
  EXPECT_EQ(cubic.specific_heat(1000.0), cubic.specific_heat(400.0));
  EXPECT_DOUBLE_EQ(cubic.specific_heat(300.0), 900.0 + 600.0 - 270.0 + 270.0);
  EXPECT_EQ(cubic.enthalpy(250.0), 0.0);
  EXPECT_NEAR(cubic.enthalpy(400.0 + 1e-9), cubic.enthalpy(400.0 - 1e-9), 1e-5);
  EXPECT_LT(cubic.enthalpy(240.0), 0.0);
}

TEST(film_temperature, is_the_one_that_the_enthalpy_came_from) {
  const ExchangeSettings settings = settings_of(3, true);
  const double masses[] = {1e-10, 3e-12, 0.0};
  const auto mass = [&](std::size_t i) { return masses[i]; };
  for (const double T : {150.0, 250.0, 300.0, 449.0, 700.0})
    for (const double start : {1.0, 300.0, 5000.0}) {
      const double H = film_enthalpy(settings.species, mass, T);
      EXPECT_NEAR(temperature_of(settings.species, mass, H, {0.0, 1e4}, start), T, 1e-11 * T);
    }
}

struct Pair {
  Parcels parcels;
  ExchangeReport report;
  double equilibrium;  // [K]
};

Pair mixed(const ExchangeSettings& settings, double T_1, double T_2, double share_1) {
  Pair pair;
  pair.parcels.species = settings.species.size();
  std::vector<double> film(pair.parcels.species, 1e-10);
  pair.parcels.add(0, 1e4 * share_1, 1e-9, 5e-13, film, {1, 0, 0}, T_1);
  pair.parcels.add(0, 1e4 * (1.0 - share_1), 1e-9, 5e-13, film, {0, 0, 0}, T_2);
  CollisionalExchange exchange(settings);
  pair.report = exchange.step(pair.parcels.view(), row_of_cells(1), cell_volume, 1e-2, on_one_rank);
  pair.equilibrium = exchange.cells().film_temperature[0];
  return pair;
}

TEST(film_temperature, of_equal_films_with_a_constant_heat_goes_to_the_mean) {
  ExchangeSettings settings = settings_of(1, true);
  settings.species[0].enthalpy.coefficients = {4180.0};
  for (const double T : {250.0, 300.0, 301.7, 389.3, 450.0})
    for (const double share : {0.01, 0.25, 0.3, 0.77})
      EXPECT_NEAR(mixed(settings, T, 400.0, share).equilibrium, share * T + (1.0 - share) * 400.0,
                  1e-11);
}

TEST(film_temperature, with_a_heat_that_rises_with_temperature_is_hotter_than_the_mean) {
  // c_p = C T: T_eq^2 is the mean of the squares.
  ExchangeSettings settings = settings_of(1, true);
  settings.species[0].enthalpy.coefficients = {0.0, 12.0};
  const Pair pair = mixed(settings, 300.0, 400.0, 0.5);
  EXPECT_NEAR(pair.equilibrium, std::sqrt(0.5 * (9e4 + 16e4)), 1e-11);
  EXPECT_EQ(pair.report.temperatures_beyond_range, 0U);
  EXPECT_GT(pair.parcels.film_temperature[0], 300.0);
  EXPECT_LT(pair.parcels.film_temperature[1], 400.0);
}

TEST(film_temperature, a_rise_of_c_p_beyond_the_range_is_held_counted_and_loses_no_enthalpy) {
  ExchangeSettings settings = settings_of(1, true);
  settings.species[0].enthalpy = {{0.0, 12.0}, 310.0, 350.0};
  const Pair pair = mixed(settings, 300.0, 400.0, 0.5);
  EXPECT_EQ(pair.report.temperatures_beyond_range, 2U);
  // h of 300 and 400 K from 310 K: -10 * 3720 and 6 * (350^2 - 310^2) + 50 * 4200; half of both
  // sums is 6 (T^2 - 310^2).
  const double mean = 0.5 * (-37200.0 + 6.0 * (122500.0 - 96100.0) + 210000.0);
  const double T = mean <= 6.0 * (122500.0 - 96100.0) ? std::sqrt(mean / 6.0 + 96100.0)
                                                      : 350.0 + (mean - 158400.0) / 4200.0;
  EXPECT_NEAR(pair.equilibrium, T, 1e-10);
}

TEST(film_temperature, does_not_exist_without_the_keyword) {
  Parcels parcels = random_parcels(2, 10, 1, 3);
  const std::vector<double> before = parcels.film_temperature;
  ExchangeView view = parcels.view();
  view.film_temperature = nullptr;
  CollisionalExchange exchange(settings_of(1));
  exchange.step(view, row_of_cells(2), cell_volume, 1e-2, on_one_rank);
  EXPECT_EQ(parcels.film_temperature, before);
  EXPECT_EQ(exchange.cells().film_temperature.size(), 0U);
}

TEST(film_temperature, of_equal_films_stays_what_it_is) {
  Parcels parcels = random_parcels(3, 20, 3, 8);
  for (double& T : parcels.film_temperature) T = 321.5;
  CollisionalExchange exchange(settings_of(3, true));
  exchange.step(parcels.view(), row_of_cells(3), cell_volume, 1e-2, on_one_rank);
  for (const double T : parcels.film_temperature) EXPECT_NEAR(T, 321.5, 1e-11);
}

}  // namespace
}  // namespace gasgrain
