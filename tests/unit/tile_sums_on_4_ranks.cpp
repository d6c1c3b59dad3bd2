// Sums over ranks whose tiles share cells.
#include "coupling/transport/tile_sums.h"

#include <gtest/gtest.h>

namespace gasgrain {
namespace {

BoxGrid grid_of(Int3 cells, std::array<bool, 3> periodic) {
  BoxGrid grid;
  grid.cells = cells;
  grid.periodic = periodic;
  return grid;
}

int wrapped(int index, int cells) {
  return ((index % cells) + cells) % cells;
}

// What rank r deposits into a cell given by its unwrapped index: distinct binary digits, so that
// sums are exact and tell who is in them.
double share(int rank, int i, int j, int k) {
  return std::pow(2.0, rank) +
         std::pow(2.0, 10 + rank) * (i + 20 + 64 * (j + 20) + 4096 * (k + 20));
}

// Every rank's tile in one list; sums are compared with a loop over all of them.
void expect_sums(const BoxGrid& grid, const std::vector<IndexBox>& tiles) {
  const Communicator world(MPI_COMM_WORLD);
  const IndexBox& mine = tiles[static_cast<std::size_t>(world.rank())];
  TileSums sums(world, grid);
  for (int turn = 0; turn < 2; ++turn) {
    sums.set_tile(mine);
    Array3<double> first(mine), second(mine, 1.0);
    for_each_cell(mine,
                  [&](int i, int j, int k) { first(i, j, k) = share(world.rank(), i, j, k); });
    sums.add_up({&first, &second});
    for_each_cell(mine, [&](int i, int j, int k) {
      double sum = 0.0, holders = 0.0;
      for (int r = 0; r < world.size(); ++r)
        for_each_cell(tiles[static_cast<std::size_t>(r)], [&](int a, int b, int c) {
          if (wrapped(a, grid.cells[0]) != wrapped(i, grid.cells[0]) ||
              wrapped(b, grid.cells[1]) != wrapped(j, grid.cells[1]) ||
              wrapped(c, grid.cells[2]) != wrapped(k, grid.cells[2]))
            return;
          sum += share(r, a, b, c);
          holders += 1.0;
        });
      EXPECT_EQ(first(i, j, k), sum) << i << ' ' << j << ' ' << k;
      EXPECT_EQ(second(i, j, k), holders);
    });
  }
}

TEST(TileSums, shared_cells_hold_the_sum_of_all_who_hold_them) {
  expect_sums(grid_of({6, 5, 4}, {false, false, false}), {{{0, 0, 0}, {4, 5, 4}},
                                                          {{2, 0, 0}, {6, 5, 4}},
                                                          {{0, 0, 0}, {6, 3, 4}},
                                                          {{3, 2, 1}, {5, 5, 4}}});
}

TEST(TileSums, periodic_images_of_a_cell_are_one_cell) {
  expect_sums(grid_of({4, 3, 2}, {true, false, true}), {{{-2, 0, -1}, {3, 3, 3}},
                                                        {{1, 0, -1}, {6, 3, 3}},
                                                        {{0, 0, 0}, {4, 1, 2}},
                                                        {{3, 1, 1}, {5, 2, 4}}});
}

TEST(TileSums, a_rank_without_a_tile_takes_part) {
  expect_sums(grid_of({4, 4, 4}, {false, false, false}), {{{0, 0, 0}, {4, 4, 4}},
                                                          {{0, 0, 0}, {0, 0, 0}},
                                                          {{1, 1, 1}, {3, 3, 3}},
                                                          {{2, 0, 0}, {4, 4, 1}}});
}

}  // namespace
}  // namespace gasgrain
