// The weights of a separable method: those of the three axes are found one by one and multiplied.
#pragma once

#include <array>
#include <vector>

namespace gasgrain {

// At most three different cells along an axis; a cell named twice has its weights added.
struct AxisWeights {
  int count = 0;
  std::array<int, 3> cell{};
  std::array<double, 3> weight{};

  void add(int cell_index, double w) {
    for (int n = 0; n < count; ++n) {
      if (cell[n] == cell_index) {
        weight[n] += w;
        return;
      }
    }
    cell[count] = cell_index;
    weight[count] = w;
    ++count;
  }
};

// Any number of cells, each named once.
struct ManyAxisWeights {
  int count = 0;
  std::vector<int> cell;
  std::vector<double> weight;

  void add(int cell_index, double w) {
    cell.push_back(cell_index);
    weight.push_back(w);
    ++count;
  }
};

// f(i, j, k, weight) for the product of three axes.
template <class Weights, class F>
void for_each_product(const std::array<Weights, 3>& axes, F&& f) {
  for (int c = 0; c < axes[2].count; ++c)
    for (int b = 0; b < axes[1].count; ++b) {
      const double w = axes[2].weight[c] * axes[1].weight[b];
      for (int a = 0; a < axes[0].count; ++a)
        f(axes[0].cell[a], axes[1].cell[b], axes[2].cell[c], w * axes[0].weight[a]);
    }
}

}  // namespace gasgrain
