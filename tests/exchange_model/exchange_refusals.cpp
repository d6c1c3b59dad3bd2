// What the exchange takes from a script and what it refuses, with the remedy.
#include <gtest/gtest.h>

#include <sstream>

#include "coupling/base/error.h"
#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

ExchangeSettings parsed(const std::string& text) {
  return parse_exchange(words_of(text));
}

template <class F>
std::string words_of_refusal(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& text) {
  return words_of_refusal([&] { parsed(text); });
}

void expect_told(const std::string& told, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(told.find(part), std::string::npos) << part << "\nis not in\n" << told;
}

TEST(exchange_settings, nothing_said_is_dry_with_the_papers_constants) {
  const ExchangeSettings s = parsed("");
  EXPECT_EQ(s.close_packing, 0.58);
  EXPECT_EQ(s.k_solid, 0.01);
  EXPECT_EQ(s.k_liquid, 0.1);
  EXPECT_EQ(s.time_scale_ratio, 4.0);
  EXPECT_EQ(s.agglomeration, Agglomeration::mean);
  EXPECT_TRUE(s.species.empty());
  EXPECT_FALSE(s.film_temperature);
  EXPECT_TRUE(s.momentum);
  EXPECT_FALSE(s.cells);
  EXPECT_EQ(s.every, 1);
}

TEST(exchange_settings, every_keyword_is_read) {
  const ExchangeSettings s = parsed(
      "close_packing 0.62 k_solid 0.02 k_liquid 0.3 time_scale_ratio 7 agglomeration variance "
      "species water density 998 heat 4900 -4.5 0.0072 range 273 373 "
      "species ethanol density 789 heat 2440 range 260 350 "
      "film_temperature 300 momentum off cells 4 5 6 every 10");
  EXPECT_EQ(s.close_packing, 0.62);
  EXPECT_EQ(s.k_solid, 0.02);
  EXPECT_EQ(s.k_liquid, 0.3);
  EXPECT_EQ(s.time_scale_ratio, 7.0);
  EXPECT_EQ(s.agglomeration, Agglomeration::variance);
  ASSERT_EQ(s.species.size(), 2U);
  EXPECT_EQ(s.species[0].name, "water");
  EXPECT_EQ(s.species[0].density, 998.0);
  EXPECT_EQ(s.species[0].enthalpy.coefficients, (std::vector<double>{4900.0, -4.5, 0.0072}));
  EXPECT_EQ(s.species[0].enthalpy.low, 273.0);
  EXPECT_EQ(s.species[0].enthalpy.high, 373.0);
  EXPECT_EQ(s.species[1].name, "ethanol");
  EXPECT_EQ(s.film_temperature, 300.0);
  EXPECT_FALSE(s.momentum);
  EXPECT_EQ(s.cells, (Int3{4, 5, 6}));
  EXPECT_EQ(s.every, 10);
  EXPECT_TRUE(parsed("momentum on agglomeration mean").momentum);
}

TEST(exchange_settings, all_faults_are_told_at_once_each_with_its_remedy) {
  expect_told(refusal("close_packing 1.2 k_solid -0.01 time_scale_ratio 0.5 agglomeration mode "
                      "species water species ethanol density -789 species ethanol density 789 "
                      "momentum maybe cells 4 0 6 every 0.5 k_liqid 0.1"),
              {"close_packing 1.2: must be from 0.05 to 0.999", "k_solid -0.01: must be from 0",
               "time_scale_ratio 0.5: must be from 1", "agglomeration \"mode\" is unknown",
               "species water: has no density. Write 'species water density 998'",
               "species ethanol density -789: must be from 1", "species ethanol: is named twice",
               "momentum maybe: must be 'on' or 'off'", "cells 0: must be from 1", "every 0.5",
               "Did you mean \"k_liquid\"?"});
}

TEST(exchange_settings, a_species_without_enthalpy_is_refused_where_films_have_temperatures) {
  expect_told(refusal("species water density 998 film_temperature 300"),
              {"species water: has no enthalpy", "heat C0 range TLO THI", "leave out "});
  expect_told(refusal("film_temperature 300"), {"there are no films", "'species'"});
  EXPECT_EQ(refusal("species water density 998"), "");
}

TEST(exchange_settings, a_heat_that_would_not_be_used_is_refused) {
  expect_told(refusal("species water density 998 heat 4180 range 273 373"),
              {"is of no use without film_temperature", "Add 'film_temperature T'"});
}

TEST(exchange_settings, heats_must_be_positive_over_a_range_that_holds_the_first_temperature) {
  expect_told(refusal("species a density 900 heat range 273 373 film_temperature 300"),
              {"species a heat: give C0 C1"});
  expect_told(refusal("species a density 900 heat 4180 film_temperature 300"),
              {"has no range", "'range 273 373'"});
  expect_told(refusal("species a density 900 heat 4180 range 373 273 film_temperature 300"),
              {"range 373 273: the lower end comes first"});
  // Positive at both ends, not in between.
  expect_told(refusal("species a density 900 heat 90010 -600 1 range 250 350 film_temperature 270 "
                      "species b density 900 heat 89990 -600 1 range 250 350"),
              {"species b heat: c_p is", "must be above 0 over its whole range 250 to 350 K"});
  expect_told(refusal("species a density 900 heat 4180 range 273 373 film_temperature 20"),
              {"film_temperature 20: is out of the range of species a, 273 to 373 K"});
  expect_told(refusal("species density 998"), {"its name comes first"});
  expect_told(refusal("k_solid nan film_temperature -5"), {"k_solid nan", "film_temperature -5"});
}

std::string view_refusal(Parcels parcels) {
  return words_of_refusal([&] { check_view(parcels.view(), 2, row_of_cells(3)); });
}

TEST(exchange_view, bad_particles_are_refused_by_number_value_and_remedy) {
  const Parcels good = random_parcels(3, 5, 2, 3);
  EXPECT_EQ(view_refusal(good), "");
  const auto with = [&](auto change) {
    Parcels bad = good;
    change(bad);
    return view_refusal(bad);
  };
  expect_told(with([](Parcels& p) { p.solid_mass[4] = -1e-9; }),
              {"parcel 4", "solid mass [kg] is -1e-09", "at least 0"});
  expect_told(with([](Parcels& p) { p.film_mass[7] = -2e-12; }),
              {"parcel 3", "film mass [kg] is -2e-12", "Set the films to 0"});
  expect_told(with([](Parcels& p) { p.film_mass[7] = std::nan(""); }), {"film mass [kg] is nan"});
  expect_told(with([](Parcels& p) { p.solid_volume[0] = HUGE_VAL; }), {"parcel 0", "is inf"});
  expect_told(with([](Parcels& p) { p.particles[2] = 0.0; }),
              {"parcel 2", "number of particles is 0, must be above 0"});
  expect_told(with([](Parcels& p) { p.film_temperature[1] = 0.0; }), {"parcel 1", "in kelvin"});
  expect_told(with([](Parcels& p) { p.cell[14] = 3; }), {"parcel 14", "cell 3", "3 of the tile"});
  EXPECT_EQ(with([](Parcels& p) { p.cell[14] = no_cell; }), "");
}

TEST(exchange_view, momentum_off_is_refused_where_films_have_inertia) {
  ExchangeSettings settings = settings_of(1);
  settings.momentum = false;
  Parcels parcels = random_parcels(1, 5, 1, 3);
  expect_told(words_of_refusal([&] {
                CollisionalExchange(settings).step(parcels.view(), row_of_cells(1), cell_volume,
                                                   1e-3, on_one_rank);
              }),
              {"momentum off", "Leave out 'momentum off'"});
}

TEST(exchange_view, temperatures_that_are_missing_are_refused) {
  Parcels parcels = random_parcels(1, 5, 1, 3);
  ExchangeView view = parcels.view();
  view.film_temperature = nullptr;
  expect_told(words_of_refusal([&] {
                CollisionalExchange(settings_of(1, true))
                    .step(view, row_of_cells(1), cell_volume, 1e-3, on_one_rank);
              }),
              {"film_temperature is set"});
}

}  // namespace
}  // namespace gasgrain
