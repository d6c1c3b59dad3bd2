#include "coupling/base/decomposition.h"

#include <gtest/gtest.h>

#include "coupling/base/array3.h"
#include "coupling/base/error.h"

namespace gasgrain {
namespace {

BoxGrid grid(int nx, int ny, int nz) {
  BoxGrid g;
  g.cells = {nx, ny, nz};
  return g;
}

TEST(decomposition, covers_every_cell_exactly_once) {
  for (int ranks : {1, 2, 3, 4, 6, 12}) {
    const BoxGrid g = grid(36, 6, 220);
    Array3<int> owners(g.all());
    for (const auto& box : decompose(g, ranks))
      for_each_cell(box, [&](int i, int j, int k) { ++owners(i, j, k); });
    for (int n : owners) ASSERT_EQ(n, 1) << ranks << " ranks";
  }
}

TEST(decomposition, cuts_the_longest_axis_first) {
  EXPECT_EQ(rank_layout(grid(36, 6, 220), 4), (Int3{1, 1, 4}));
}

TEST(decomposition, says_how_many_ranks_a_grid_allows) {
  try {
    decompose(grid(4, 1, 1), 5);
    FAIL() << "5 ranks on 4 cells were accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("use 2"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace gasgrain
