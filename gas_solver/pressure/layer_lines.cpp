#include "gas_solver/pressure/layer_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gasgrain {

LayerLines::LayerLines(const BoxGrid& grid, int axis)
    : cells_(grid.cells[axis]), cyclic_(grid.periodic[axis] && grid.cells[axis] > 1) {
  const auto plane = plane_axes(axis);
  for (int n = 0; n < 2; ++n) {
    const int cells = grid.cells[plane[n]];
    for (int m = 0; m < cells; ++m) {
      const double angle = (grid.periodic[plane[n]] ? 2.0 : 1.0) * M_PI * m / cells;
      eigenvalue_[n].push_back(2.0 - 2.0 * std::cos(angle));
    }
  }
  for (auto* values : {&value_, &upper_, &corner_}) values->resize(cells_);
}

void LayerLines::set(Layers layers, bool singular) {
  layers_ = std::move(layers);
  pin_ = 0;
  if (!singular) return;
  for (const auto* c : {&layers_.across, &layers_.along[0], &layers_.along[1]})
    pin_ = std::max(pin_, *std::max_element(c->begin(), c->end()));
  if (pin_ == 0) pin_ = 1;  // a single cell
}

void LayerLines::solve(int begin, int end, double* data, std::ptrdiff_t line_stride,
                       std::ptrdiff_t value_stride, double scale) {
  const int waves = static_cast<int>(eigenvalue_[0].size());
  for (int first = begin; first < end; first += bundle) {
    const int count = std::min(bundle, end - first);
    double* lines = data + (first - begin) * line_stride;
    Values wave_0;
    Values wave_1;
    Values joined;
    for (int b = 0; b < bundle; ++b) {
      const int m = first + std::min(b, count - 1);  // what is over repeats the last line
      wave_0[b] = eigenvalue_[0][m % waves];
      wave_1[b] = eigenvalue_[1][m / waves];
      joined[b] = m == 0 ? pin_ : 0.0;
    }
    for (int n = 0; n < cells_; ++n)
      for (int b = 0; b < count; ++b)
        value_[n][b] = scale * lines[b * line_stride + n * value_stride];
    solve_bundle(wave_0, wave_1, joined);
    for (int n = 0; n < cells_; ++n)
      for (int b = 0; b < count; ++b) lines[b * line_stride + n * value_stride] = value_[n][b];
  }
}

// Round a periodic axis the last unknown is set apart: the others are solved for the source and for
// a unit value of the last one, and the last row then gives it.
void LayerLines::solve_bundle(const Values& wave_0, const Values& wave_1, const Values& joined) {
  const std::vector<double>& across = layers_.across;
  const auto centre = [&](int n, int b) {
    const double all = across[n] + across[n + 1] + layers_.storage[n] +
                       layers_.along[0][n] * wave_0[b] + layers_.along[1][n] * wave_1[b];
    return n == cells_ - 1 ? all + joined[b] : all;
  };
  const int unknowns = cyclic_ ? cells_ - 1 : cells_;
  for (int n = 0; n < unknowns; ++n) {
    const int before = std::max(n - 1, 0);
    const double lower = n > 0 ? across[n] : 0.0;
    const double to_last = n > 0 ? 0.0 : across[0];
    for (int b = 0; b < bundle; ++b) {
      const double pivot = 1.0 / (centre(n, b) - lower * upper_[before][b]);
      value_[n][b] = (value_[n][b] + lower * value_[before][b]) * pivot;
      if (cyclic_) corner_[n][b] = (to_last + lower * corner_[before][b]) * pivot;
      upper_[n][b] = across[n + 1] * pivot;
    }
  }
  if (cyclic_)
    for (int b = 0; b < bundle; ++b) corner_[unknowns - 1][b] += upper_[unknowns - 1][b];
  for (int n = unknowns - 2; n >= 0; --n)
    for (int b = 0; b < bundle; ++b) {
      value_[n][b] += upper_[n][b] * value_[n + 1][b];
      if (cyclic_) corner_[n][b] += upper_[n][b] * corner_[n + 1][b];
    }
  if (!cyclic_) return;
  const int last = cells_ - 1;
  for (int b = 0; b < bundle; ++b) {
    const double left = across[last];
    const double right = across[cells_];
    value_[last][b] = (value_[last][b] + left * value_[last - 1][b] + right * value_[0][b]) /
                      (centre(last, b) - left * corner_[last - 1][b] - right * corner_[0][b]);
  }
  for (int n = 0; n < unknowns; ++n)
    for (int b = 0; b < bundle; ++b) value_[n][b] += corner_[n][b] * value_[last][b];
}

}  // namespace gasgrain
