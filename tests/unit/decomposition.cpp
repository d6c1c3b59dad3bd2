#include "coupling/base/decomposition.h"

#include <gtest/gtest.h>

#include <chrono>

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

std::string refusal(const BoxGrid& g, int ranks) {
  try {
    rank_layout(g, ranks);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(decomposition, says_how_many_ranks_a_grid_allows) {
  EXPECT_THROW(decompose(grid(4, 1, 1), 5), Error);
  EXPECT_EQ(refusal(grid(4, 1, 1), 5),
            "5 gas ranks cannot share a grid of 4 x 1 x 1 cells with at least 2 cells a side: use "
            "2.");
}

TEST(decomposition, number_it_names_is_the_next_that_fits) {
  for (const BoxGrid& g : {grid(4, 3, 4), grid(7, 6, 22), grid(1, 13, 10), grid(3, 3, 3)})
    for (int ranks = 2; ranks < 200; ++ranks) {
      const std::string text = refusal(g, ranks);
      if (text.empty()) continue;
      int fewer = ranks - 1;
      while (!refusal(g, fewer).empty()) --fewer;
      ASSERT_NE(text.find(fmt::format(" use {}.", fewer)), std::string::npos) << text;
    }
}

TEST(decomposition, too_many_ranks_by_far_are_refused_at_once) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_NE(refusal(grid(36, 6, 220), 1000000).find(" use 5940."), std::string::npos);
  EXPECT_NE(refusal(grid(1001, 1001, 3), 1000000).find(" use 250000."), std::string::npos);
  // Takes milliseconds; a search that counts down one by one takes minutes.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

}  // namespace
}  // namespace gasgrain
