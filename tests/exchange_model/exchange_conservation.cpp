// What a step of the collisional exchange conserves, and the bounds that it keeps.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

constexpr int cells = 6;
constexpr int parcels_a_cell = 40;
// Sums of 40 parcels of random size, each with some ten roundings: below 1e-14 of the sum.
constexpr double round_off = 2e-14;

struct Case {
  std::size_t species;
  bool warm;
  bool film_has_inertia;
  double fraction;  // theta_s
  double dt;        // [s]; collision times are some 1e-4 s, films take a hundred of them
  Agglomeration agglomeration = Agglomeration::mean;
};

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const std::size_t species : {0U, 1U, 3U})
    for (const bool warm : {false, true})
      for (const bool inertia : {true, false})
        for (const double fraction : {0.01, 0.2, 0.8})  // 0.8: beyond close packing
          for (const double dt : {1e-6, 1e-2, 1e3})
            for (const Agglomeration a : {Agglomeration::mean, Agglomeration::variance})
              if (species > 0 || !warm) all.push_back({species, warm, inertia, fraction, dt, a});
  return all;
}

struct Stepped {
  ExchangeSettings settings;
  Parcels before;
  Parcels after;
  ExchangeReport report;
  ExchangeCells cells_after;
};

Stepped stepped(const Case& c) {
  Stepped r;
  r.settings = settings_of(c.species, c.warm);
  r.settings.agglomeration = c.agglomeration;
  r.before = random_parcels(cells, parcels_a_cell, c.species, 11, c.fraction);
  r.after = r.before;
  CollisionalExchange exchange(r.settings);
  ExchangeView view = r.after.view();
  view.film_has_inertia = c.film_has_inertia;
  r.report = exchange.step(view, row_of_cells(cells), cell_volume, c.dt, on_one_rank);
  r.cells_after = exchange.cells();
  return r;
}

TEST(exchange_conservation, each_cell_keeps_species_momentum_enthalpy_and_solids) {
  for (const Case& c : all_cases()) {
    const Stepped r = stepped(c);
    const auto was = contents(r.before, cells, r.settings, c.film_has_inertia);
    const auto is = contents(r.after, cells, r.settings, c.film_has_inertia);
    for (std::size_t k = 0; k < cells; ++k) {
      for (std::size_t i = 0; i < c.species; ++i)
        EXPECT_NEAR(is[k].species[i], was[k].species[i], round_off * was[k].species[i]);
      EXPECT_LT((is[k].momentum - was[k].momentum).norm(), round_off * was[k].momentum_scale);
      // h is read off T, which is known to 2e-16 of itself: some 2e-15 of what was mixed.
      EXPECT_NEAR(is[k].enthalpy, was[k].enthalpy, round_off * was[k].enthalpy);
      EXPECT_EQ(is[k].solid, was[k].solid);
    }
  }
}

TEST(exchange_conservation, no_value_leaves_the_range_between_its_own_and_equilibrium) {
  const auto expect_between = [](double x, double a, double b) {
    const double slack = 1e-14 * (std::abs(a) + std::abs(b));  // of the roundings of x
    EXPECT_GE(x, std::min(a, b) - slack);
    EXPECT_LE(x, std::max(a, b) + slack);
  };
  for (const Case& c : all_cases()) {
    const Stepped r = stepped(c);
    for (std::size_t p = 0; p < r.after.count(); ++p) {
      const std::uint32_t k = r.after.cell[p];
      for (std::size_t i = 0; i < c.species; ++i) {
        const std::size_t f = p * c.species + i;
        expect_between(r.after.film_mass[f], r.before.film_mass[f],
                       r.cells_after.species_ratio[i][k] * r.before.solid_mass[p]);
        EXPECT_GE(r.after.film_mass[f], 0.0);
      }
      for (std::size_t d = 0; d < 3; ++d)
        expect_between(r.after.velocity[3 * p + d], r.before.velocity[3 * p + d],
                       r.cells_after.equilibrium_velocity[d][k]);
      if (c.warm) {
        const double T = r.before.film_temperature[p];
        const double T_eq = r.cells_after.film_temperature[k];
        const double T_after = r.after.film_temperature[p];
        if (r.before.film(p) > 0.0)  // to the bit
          EXPECT_TRUE(T_after >= std::min(T, T_eq) && T_after <= std::max(T, T_eq));
        else
          EXPECT_EQ(T_after, T_eq);
      }
    }
  }
}

TEST(exchange_conservation, the_report_tells_the_energy_that_is_lost_and_the_liquid_that_moves) {
  for (const Case& c : all_cases()) {
    const Stepped r = stepped(c);
    const auto was = contents(r.before, cells, r.settings, c.film_has_inertia);
    const auto is = contents(r.after, cells, r.settings, c.film_has_inertia);
    double lost = 0.0;
    double had = 0.0;
    double moved = 0.0;
    for (std::size_t k = 0; k < cells; ++k) {
      lost += was[k].energy - is[k].energy;
      had += was[k].energy;
    }
    for (std::size_t p = 0; p < r.after.count(); ++p)
      for (std::size_t f = p * c.species; f < (p + 1) * c.species; ++f)
        moved +=
            0.5 * r.after.particles[p] * std::abs(r.after.film_mass[f] - r.before.film_mass[f]);
    EXPECT_GT(r.report.energy_lost, 0.0);
    EXPECT_NEAR(r.report.energy_lost, lost, 1e-13 * had);
    EXPECT_EQ(r.report.liquid_moved > 0.0, c.species > 0);
    EXPECT_NEAR(r.report.liquid_moved, moved, 1e-13 * moved);
    EXPECT_EQ(r.report.parcels, r.after.count());
  }
}

TEST(exchange_conservation, momentum_off_leaves_every_velocity_and_exchanges_the_same_films) {
  ExchangeSettings settings = settings_of(2);
  Parcels on = random_parcels(cells, parcels_a_cell, 2, 5);
  const std::vector<double> velocity = on.velocity;
  Parcels off = on;
  ExchangeView view = on.view();
  view.film_has_inertia = false;
  CollisionalExchange(settings).step(view, row_of_cells(cells), cell_volume, 1e-2, on_one_rank);
  settings.momentum = false;
  view = off.view();
  view.film_has_inertia = false;
  const ExchangeReport report =
      CollisionalExchange(settings).step(view, row_of_cells(cells), cell_volume, 1e-2, on_one_rank);
  EXPECT_EQ(off.velocity, velocity);
  EXPECT_NE(on.velocity, velocity);
  EXPECT_EQ(off.film_mass, on.film_mass);
  EXPECT_EQ(report.energy_lost, 0.0);
}

}  // namespace
}  // namespace gasgrain
