#include <gtest/gtest.h>

#include "coupling/base/decomposition.h"
#include "coupling/transport/route.h"

namespace gasgrain {
namespace {

BoxGrid grid_of(std::array<bool, 3> periodic) {
  BoxGrid grid;
  grid.cells = {6, 4, 10};
  grid.periodic = periodic;
  return grid;
}

TEST(routes, every_cell_of_a_tile_has_exactly_one_gas_rank) {
  const BoxGrid grid = grid_of({true, false, true});
  const IndexBox tile{{-2, 0, 7}, {3, 4, 13}};  // across two periodic sides
  Array3<int> visits(tile);
  const auto boxes = decompose(grid, 4);
  for (const auto& route : make_routes(grid, tile, boxes, false))
    for (const auto& piece : route.pieces)
      for_each_cell(piece.gas_cells, [&](int i, int j, int k) {
        EXPECT_TRUE(boxes[route.partner].contains(i, j, k));
        ++visits(i + piece.shift[0], j + piece.shift[1], k + piece.shift[2]);
      });
  for (const int n : visits) EXPECT_EQ(n, 1);
}

TEST(routes, both_sides_list_the_same_pieces_in_the_same_order) {
  const BoxGrid grid = grid_of({true, true, false});
  const auto boxes = decompose(grid, 3);
  const std::vector<IndexBox> tiles{{{-1, -1, 0}, {4, 5, 6}}, {{2, -1, 4}, {7, 5, 10}}};
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const auto from_dem = make_routes(grid, tiles[t], boxes, false);
      const auto from_gas = make_routes(grid, boxes[b], tiles, true);
      const auto cells = [](const std::vector<Route>& routes, std::size_t partner) {
        for (const auto& route : routes)
          if (route.partner == static_cast<int>(partner)) return route.cells();
        return std::size_t{0};
      };
      EXPECT_EQ(cells(from_dem, b), cells(from_gas, t));
    }
}

TEST(routes, a_partner_without_common_cells_gets_no_message) {
  const BoxGrid grid = grid_of({false, false, false});
  const auto routes = make_routes(grid, {{0, 0, 0}, {6, 4, 2}}, decompose(grid, 2), false);
  ASSERT_EQ(routes.size(), 1U);
  EXPECT_EQ(routes[0].partner, 0);
}

TEST(routes, an_empty_tile_has_no_routes) {
  const BoxGrid grid = grid_of({false, false, false});
  EXPECT_TRUE(make_routes(grid, IndexBox{}, decompose(grid, 2), false).empty());
}

}  // namespace
}  // namespace gasgrain
