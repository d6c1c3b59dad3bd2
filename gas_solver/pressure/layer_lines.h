// The tridiagonal systems that layers become in wave numbers: for each pair of them one line of
// unknowns along the axis,
//   (storage_n + along_n . eigenvalues) x_n + across_n (x_n - x_n-1) + across_n+1 (x_n - x_n+1) =
//   source_n,
// solved by Thomas' algorithm. With coefficients c of one layer the eigenvalues along a transformed
// axis of n cells are
//   c (2 - 2 cos(pi m / n)) cosine, m = 0 .. n-1;   c (2 - 2 cos(2 pi m / n)) Fourier.
#pragma once

#include "gas_solver/pressure/layers.h"

namespace gasgrain {

class LayerLines {
 public:
  LayerLines(const BoxGrid& grid, int axis);

  // The unknown of line m that no coefficient fixes when the system is singular, m = 0, is joined
  // to the value 0 at its end: sources that sum to 0 then make that end 0.
  void set(Layers layers, bool singular);

  // Lines begin .. end - 1, counted with the first of plane_axes(axis) fastest: value n of line m
  // is data[(m - begin) line_stride + n value_stride]. In the source, out the unknowns times scale.
  void solve(int begin, int end, double* data, std::ptrdiff_t line_stride,
             std::ptrdiff_t value_stride, double scale);

 private:
  static constexpr int bundle = 16;  // lines side by side, for the vector unit
  using Values = std::array<double, bundle>;
  void solve_bundle(const Values& wave_0, const Values& wave_1, const Values& joined);

  int cells_;
  bool cyclic_;
  std::array<std::vector<double>, 2> eigenvalue_;
  Layers layers_;
  double pin_ = 0;
  std::vector<Values> value_, upper_, corner_;  // of the bundle at work
};

}  // namespace gasgrain
