// Parcels of one cell on several ranks exchange as on one rank.
#include <gtest/gtest.h>
#include <mpi.h>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/liquid_spread.h"
#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

constexpr int cells = 6;
constexpr std::size_t species = 2;
constexpr double tolerance = 1e-12;  // sums over a cell are added in another order

// All ranks have the whole tile.
void on_all_ranks(const std::vector<Array3<double>*>& fields) {
  for (Array3<double>* field : fields)
    MPI_Allreduce(MPI_IN_PLACE, field->data(), static_cast<int>(field->size()), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
}

double sum_of(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

struct Fractions {
  double solids;
  bool last_rank_empty;
};

TEST(exchange_on_ranks, parcels_of_a_cell_on_several_ranks_step_as_on_one) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  ASSERT_EQ(ranks, 4);
  for (const Fractions& f : {Fractions{0.2, false}, Fractions{0.2, true}, Fractions{0.8, false}}) {
    Parcels whole = random_parcels(cells, 50, species, 51, f.solids);
    const std::size_t sharing = f.last_rank_empty ? 3 : 4;
    Parcels mine;
    mine.species = species;
    std::vector<std::size_t> number;
    for (std::size_t p = 0; p < whole.count(); ++p)
      if (p % sharing == static_cast<std::size_t>(rank)) {
        mine.add_from(whole, p, whole.particles[p]);
        number.push_back(p);
      }
    CollisionalExchange alone(settings_of(species, true));
    CollisionalExchange shared(settings_of(species, true));
    Array3<double> eta_alone, eta_shared;
    for (int n = 0; n < 20; ++n) {
      const ExchangeReport all =
          alone.step(whole.view(), row_of_cells(cells), cell_volume, 2e-4, on_one_rank);
      const ExchangeReport share =
          shared.step(mine.view(), row_of_cells(cells), cell_volume, 2e-4, on_all_ranks);
      const auto same_sum = [&](double of_share, double of_all) {
        EXPECT_NEAR(sum_of(of_share), of_all, tolerance * std::abs(of_all) + 1e-25);
      };
      same_sum(static_cast<double>(share.parcels), static_cast<double>(all.parcels));
      // Beyond close packing the first step equalises all, and what the later ones see is rounding.
      if (f.solids > 0.5 && n > 0) continue;
      same_sum(static_cast<double>(share.at_close_packing),
               static_cast<double>(all.at_close_packing));
      same_sum(share.liquid_moved, all.liquid_moved);
      same_sum(share.energy_lost, all.energy_lost);
    }
    for (std::size_t m = 0; m < number.size(); ++m) {
      const std::size_t p = number[m];
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(mine.velocity[3 * m + d], whole.velocity[3 * p + d], tolerance);
      for (std::size_t i = 0; i < species; ++i) {
        const double film = whole.film_mass[p * species + i];
        EXPECT_NEAR(mine.film_mass[m * species + i], film, tolerance * film);
      }
      EXPECT_NEAR(mine.film_temperature[m], whole.film_temperature[p], tolerance * 300.0);
    }
    liquid_spread(whole.view(), alone.cells(), on_one_rank, eta_alone);
    liquid_spread(mine.view(), shared.cells(), on_all_ranks, eta_shared);
    for (std::size_t c = 0; c < cells; ++c) {
      EXPECT_NEAR(eta_shared[c], eta_alone[c], tolerance);
      EXPECT_NEAR(shared.cells().sauter_radius[c], alone.cells().sauter_radius[c], 1e-16);
    }
  }
}

}  // namespace
}  // namespace gasgrain
