// The exchange against the paper's equations: a step, what is known of the cells, single formulas.
#include <gtest/gtest.h>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/collision_time.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/liquid_spread.h"
#include "tests/exchange_model/exchange_reference.h"

namespace gasgrain {
namespace {

constexpr std::size_t cells = 5;

TEST(exchange_formulas, a_step_is_that_of_three_parcels_for_each_one_put_together) {
  for (const std::size_t species : {0U, 1U, 3U})
    for (const bool film_has_inertia : {true, false})
      for (const double dt : {1e-6, 1e-3, 1.0, 1e4}) {
        const ExchangeSettings settings = settings_of(species, species > 0);
        const Parcels before = random_parcels(cells, 40, species, 21);
        Parcels parcels = before;
        ExchangeView view = parcels.view();
        view.film_has_inertia = film_has_inertia;
        CollisionalExchange exchange(settings);
        exchange.step(view, row_of_cells(cells), cell_volume, dt, on_one_rank);
        const Parcels expected = reference::step(before, cells, settings, dt, film_has_inertia);
        // u_eq, lambda and T_eq come of sums over 40 parcels.
        for (std::size_t f = 0; f < parcels.film_mass.size(); ++f)
          EXPECT_NEAR(parcels.film_mass[f], expected.film_mass[f], 1e-13 * expected.film_mass[f]);
        for (std::size_t k = 0; k < parcels.velocity.size(); ++k)
          EXPECT_NEAR(parcels.velocity[k], expected.velocity[k], 1e-13);
        for (std::size_t p = 0; p < parcels.count(); ++p)
          EXPECT_NEAR(parcels.film_temperature[p], expected.film_temperature[p], 1e-10);
      }
}

TEST(exchange_formulas, cells_hold_the_measures_of_the_paper) {
  for (const double fraction : {0.05, 0.2, 0.5}) {
    const ExchangeSettings settings = settings_of(3, true);
    Parcels parcels = random_parcels(cells, 40, 3, 22, fraction);
    const Parcels before = parcels;
    CollisionalExchange exchange(settings);
    exchange.step(parcels.view(), row_of_cells(cells), cell_volume, 1e-3, on_one_rank);
    const ExchangeCells& is = exchange.cells();
    for (std::uint32_t c = 0; c < cells; ++c) {
      const reference::Cell cell = reference::cell_of(before, c, settings);
      const auto near = [](double value, reference::Real expected) {
        EXPECT_NEAR(value, static_cast<double>(expected), 1e-12 * std::abs(expected));
      };
      for (int d = 0; d < 3; ++d) near(is.equilibrium_velocity[d][c], cell.velocity[d]);
      near(is.rms_velocity[c], cell.rms);
      near(is.collision_time[c], cell.tau);
      near(is.particle_fraction[c], cell.particle_fraction);
      near(is.solid_fraction[c], cell.solid_fraction);
      near(is.close_packing[c], cell.close_packing);
      near(is.sauter_radius[c], cell.r32);
      near(is.liquid_ratio[c], cell.liquid_ratio);
      for (std::size_t i = 0; i < 3; ++i) near(is.species_ratio[i][c], cell.ratio[i]);
      near(is.film_temperature[c], cell.temperature);
    }
  }
}

TEST(exchange_formulas, spread_of_the_liquid_is_that_of_62) {
  const ExchangeSettings settings = settings_of(2);
  Parcels parcels = random_parcels(cells, 40, 2, 23);
  CollisionalExchange exchange(settings);
  exchange.step(parcels.view(), row_of_cells(cells), cell_volume, 0.1, on_one_rank);
  Array3<double> eta;
  liquid_spread(parcels.view(), exchange.cells(), on_one_rank, eta);
  for (std::uint32_t c = 0; c < cells; ++c) {
    const double expected = static_cast<double>(reference::cell_of(parcels, c, settings).eta);
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(eta[c], expected, 1e-12 * expected);
  }
  exchange.step(parcels.view(), row_of_cells(cells), cell_volume, 1e12, on_one_rank);
  liquid_spread(parcels.view(), exchange.cells(), on_one_rank, eta);
  for (const double value : eta) EXPECT_LT(value, 1e-6);
}

TEST(exchange_formulas, collision_time_of_the_papers_channel_is_as_its_text_states) {
  // "U_rms ... approximately 1.5 m/s", 50 um, a fraction of 0.2 at most: "0.0002 s at the nozzle".
  // (13) gives 1.1e-4 s with 0.2 and 2.8e-4 s with half of it; (21)'s factor would take 4.2 off.
  EXPECT_NEAR(1.0 / collision_frequency(1.5, 50e-6, 0.2, 0.58), 1.1e-4, 0.05e-4);
  EXPECT_NEAR(1.0 / collision_frequency(1.5, 50e-6, 0.1, 0.58), 2.8e-4, 0.05e-4);
}

TEST(exchange_formulas, close_packing_of_wet_particles_leaves_that_of_their_solids) {
  EXPECT_DOUBLE_EQ(close_packing_of_wet(0.58, 0.2, 0.2), 0.58);
  // theta_p reaches theta_cp when theta_s reaches that of the solids.
  EXPECT_DOUBLE_EQ(close_packing_of_wet(0.58, 0.6, 0.58), 0.6);
  EXPECT_EQ(close_packing_of_wet(0.58, 0.5, 0.1), 1.0);
  EXPECT_EQ(close_packing_of_wet(0.58, 0.5, 0.0), 1.0);
}

TEST(exchange_formulas, steps_of_any_length_keep_between_all_and_nothing) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Agglomeration agglomeration : {Agglomeration::mean, Agglomeration::variance})
    for (const double x_u : {0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300, infinite})
      for (const double x_t : {0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300, infinite}) {
        const Relaxation r = relaxation(x_u, x_t, agglomeration);
        EXPECT_GE(r.velocity_kept, 0.0);
        EXPECT_LE(r.velocity_kept, r.film_kept);
        EXPECT_LE(r.film_kept, 1.0);
        EXPECT_NEAR(r.film_kept + r.film_given, 1.0, 3e-16);
        if (x_t == 1e-9) {  // without cancellation: to 1e-15 of itself, not of 1
          const double expected =
              agglomeration == Agglomeration::mean ? 1e-9 / (1.0 + 1e-9) : 0.5e-9 * (1.0 - 0.75e-9);
          EXPECT_NEAR(r.film_given, expected, 2e-15 * expected);
        }
      }
}

}  // namespace
}  // namespace gasgrain
