#include "gas_solver/packing_limit.h"

#include <gtest/gtest.h>

#include <numeric>

#include "coupling/base/error.h"
#include "tests/random_packing.h"

namespace gasgrain {
namespace {

BoxGrid grid_of(std::array<bool, 3> periodic) {
  BoxGrid grid;
  grid.cells = {5, 4, 6};
  grid.periodic = periodic;
  return grid;
}

double sum_of_own(const Domain& domain, const Array3<double>& field) {
  double sum = 0.0;
  for_each_cell(domain.own(), [&](int i, int j, int k) { sum += field(i, j, k); });
  return sum;
}

TEST(packing_limit, moves_the_excess_to_neighbours_and_loses_none) {
  for (const bool periodic : {false, true}) {
    const Domain domain(grid_of({periodic, periodic, periodic}), Communicator(MPI_COMM_SELF));
    Halo halo(domain);
    Array3<double> solids(domain.box(), 0.5);
    solids(0, 0, 0) = 1.9;  // a corner: three of its neighbours are missing without periodic sides
    solids(2, 2, 3) = 1.2;
    const double before = sum_of_own(domain, solids);
    EXPECT_EQ(move_solids_above_limit(domain, halo, solids), 2);
    EXPECT_NEAR(sum_of_own(domain, solids), before, 1e-12 * before);
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      EXPECT_LE(solids(i, j, k), solids_limit + 1e-11);
      EXPECT_GE(solids(i, j, k), 0.5 - 1e-12);
    });
  }
}

// The solids of spheres `cells_across` cells wide, by the exact method, in a periodic box of
// `side` diameters.
Array3<double> solids_of(const std::vector<Vec3>& spheres, double side, int cells_across,
                         const Domain& domain) {
  Cloud cloud;
  for (const Vec3& x : spheres) cloud.add(x, Vec3::Zero(), 0.5);
  const BoxGrid& grid = domain.grid();
  const TileFrame frame{grid, grid.all().grown(cells_across + 1)};
  ParticleWeights weights;
  weights.find(cloud.view(), VoidFractionExact{}, frame);
  Array3<double> deposited(frame.tile);
  deposit_solid_volume(cloud.view(), weights, deposited);
  Array3<double> solids(domain.box());
  const int n = static_cast<int>(std::lround(side)) * cells_across;
  for_each_cell(frame.tile, [&](int i, int j, int k) {
    const auto wrap = [n](int a) { return ((a % n) + n) % n; };
    solids(wrap(i), wrap(j), wrap(k)) += deposited(i, j, k) / grid.cell_volume();
  });
  return solids;
}

Domain periodic_domain(double side, int cells_across) {
  BoxGrid grid;
  grid.hi = Vec3::Constant(side);
  const int n = static_cast<int>(std::lround(side)) * cells_across;
  grid.cells = {n, n, n};
  grid.periodic = {true, true, true};
  return {grid, Communicator(MPI_COMM_SELF)};
}

void expect_moved_and_kept(const Domain& domain, Array3<double> solids) {
  const Array3<double> before = solids;
  long full = 0;
  for_each_cell(domain.own(),
                [&](int i, int j, int k) { full += solids(i, j, k) > solids_limit + 1e-12; });
  ASSERT_GT(full, 0);
  Halo halo(domain);
  EXPECT_EQ(move_solids_above_limit(domain, halo, solids), full);
  const double sum = sum_of_own(domain, before);
  EXPECT_NEAR(sum_of_own(domain, solids), sum, 1e-12 * sum);
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    EXPECT_LE(solids(i, j, k), solids_limit + 1e-9);
    // No cell pays for its neighbours: it loses what it had above the limit at most.
    EXPECT_GE(solids(i, j, k), std::min(before(i, j, k), solids_limit) - 1e-9);
  });
}

TEST(packing_limit, gives_gas_to_the_cells_within_a_resolved_sphere) {
  for (const int cells_across : {2, 5, 10}) {
    const Domain domain = periodic_domain(3.0, cells_across);
    expect_moved_and_kept(domain, solids_of({Vec3(1.37, 1.52, 1.44)}, 3.0, cells_across, domain));
  }
}

TEST(packing_limit, gives_gas_to_every_cell_of_a_dense_packing_of_resolved_spheres) {
  Random random(3);
  const double side = 6.0;
  const auto spheres = random_packing(0.58, side, random);
  for (const int cells_across : {2, 5}) {
    const Domain domain = periodic_domain(side, cells_across);
    expect_moved_and_kept(domain, solids_of(spheres, side, cells_across, domain));
  }
}

// Round an odd number of cells a chequerboard does not close.
TEST(packing_limit, fits_a_bed_into_any_number_of_periodic_cells) {
  for (const int n : {1, 2, 3, 4, 5, 7})
    for (unsigned seed = 0; seed < 20; ++seed) {
      BoxGrid grid;
      grid.cells = {n, n, n + 3};
      grid.periodic = {true, true, true};
      const Domain domain(grid, Communicator(MPI_COMM_SELF));
      Random random(seed);
      Array3<double> solids(domain.box());
      for_each_cell(domain.own(), [&](int i, int j, int k) {
        solids(i, j, k) = random.between(0.0, 1.0) < 0.3 ? 0.2 : 1.0;
      });
      solids(0, 0, 0) = 1.5;
      const double mean = sum_of_own(domain, solids) / static_cast<double>(domain.own().size());
      for_each_cell(domain.own(), [&](int i, int j, int k) { solids(i, j, k) *= 0.7 / mean; });
      expect_moved_and_kept(domain, solids);
    }
}

TEST(packing_limit, leaves_a_bed_below_the_limit_bitwise_alone) {
  const Domain domain(grid_of({false, false, false}), Communicator(MPI_COMM_SELF));
  Halo halo(domain);
  Array3<double> solids(domain.box(), 0.64);
  EXPECT_EQ(move_solids_above_limit(domain, halo, solids), 0);
  for_each_cell(domain.own(), [&](int i, int j, int k) { EXPECT_EQ(solids(i, j, k), 0.64); });
}

TEST(packing_limit, says_so_when_the_solids_have_no_room) {
  const Domain domain(grid_of({false, false, false}), Communicator(MPI_COMM_SELF));
  Halo halo(domain);
  Array3<double> solids(domain.box(), 0.9);
  EXPECT_THROW(move_solids_above_limit(domain, halo, solids), Error);
}

}  // namespace
}  // namespace gasgrain
