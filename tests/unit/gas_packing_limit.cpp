#include "gas_solver/packing_limit.h"

#include <gtest/gtest.h>

#include <numeric>

#include "coupling/base/error.h"

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
