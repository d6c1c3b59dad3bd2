#include "coupling/exchange/separable_spread.h"

#include <algorithm>

namespace gasgrain {
namespace {

constexpr int rows_at_once = 32;  // fewer waste less of a band's corners, more run faster

Int3 extents(const IndexBox& box) {
  return {box.extent(0), box.extent(1), box.extent(2)};
}

// f(first element of a row in the array, first in the box) for the rows along x of a box.
template <class F>
void for_each_row(const IndexBox& box, const Array3<double>& array, F&& f) {
  std::ptrdiff_t n = 0;
  for (int k = box.lo[2]; k < box.hi[2]; ++k)
    for (int j = box.lo[1]; j < box.hi[1]; ++j) {
      f(array.offset(box.lo[0], j, k), n);
      n += box.extent(0);
    }
}

std::vector<double> cut(const IndexBox& box, const Array3<double>& array) {
  std::vector<double> values(box.size());
  for_each_row(box, array, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
    std::copy_n(array.data() + from, box.extent(0), values.data() + to);
  });
  return values;
}

}  // namespace

SeparableSpread::SeparableSpread(const std::array<AxisSpread, 3>& axes) {
  for (int d = 0; d < 3; ++d) {
    inner_.lo[d] = axes[d].inner.lo;
    inner_.hi[d] = axes[d].inner.hi;
    outer_.lo[d] = axes[d].outer.lo;
    outer_.hi[d] = axes[d].outer.hi;
    spread_[d] = banded(axes[d].share);
    gather_[d] = banded(axes[d].share.transpose());
  }
}

SeparableSpread::Banded SeparableSpread::banded(const Eigen::MatrixXd& matrix) {
  Banded band{matrix, {}};
  const auto columns = static_cast<int>(matrix.cols());
  for (Eigen::Index row = 0; row < matrix.rows(); row += rows_at_once) {
    const auto block =
        matrix.middleRows(row, std::min<Eigen::Index>(rows_at_once, matrix.rows() - row));
    IndexRange used{0, columns};
    while (used.hi > used.lo && block.col(used.hi - 1).isZero(0.0)) --used.hi;
    while (used.lo < used.hi && block.col(used.lo).isZero(0.0)) ++used.lo;
    band.columns.push_back(used);
  }
  return band;
}

std::vector<double> SeparableSpread::apply(const Banded& map, int axis, Int3& extent,
                                           const std::vector<double>& in) {
  using Matrix = Eigen::MatrixXd;
  const auto to = static_cast<int>(map.matrix.rows());
  const int from = extent[axis];
  extent[axis] = to;
  std::vector<double> out(static_cast<std::size_t>(extent[0]) * extent[1] * extent[2]);
  const Eigen::Index plane = static_cast<Eigen::Index>(extent[0]) * (axis == 2 ? extent[1] : 1);
  const Eigen::Index lines = axis == 0 ? static_cast<Eigen::Index>(extent[1]) * extent[2] : plane;
  const int layers = axis == 1 ? extent[2] : 1;
  for (int layer = 0; layer < layers; ++layer) {
    const double* source = in.data() + layer * lines * from;
    double* target = out.data() + layer * lines * to;
    for (std::size_t block = 0; block < map.columns.size(); ++block) {
      const Eigen::Index row = static_cast<Eigen::Index>(block) * rows_at_once;
      const Eigen::Index rows = std::min<Eigen::Index>(rows_at_once, to - row);
      const IndexRange used = map.columns[block];
      const auto share = map.matrix.block(row, used.lo, rows, used.extent());
      if (axis == 0) {
        const Eigen::Map<const Matrix> a(source, from, lines);
        Eigen::Map<Matrix> b(target, to, lines);
        b.middleRows(row, rows).noalias() = share * a.middleRows(used.lo, used.extent());
      } else {
        const Eigen::Map<const Matrix> a(source, lines, from);
        Eigen::Map<Matrix> b(target, lines, to);
        b.middleCols(row, rows).noalias() =
            a.middleCols(used.lo, used.extent()) * share.transpose();
      }
    }
  }
  return out;
}

// The axes in the order in which memory runs: what is added grows, so that the longest strides come
// last, and what is gathered shrinks along them first.
void SeparableSpread::add(const Array3<double>& points, Array3<double>& cells) const {
  if (inner_.empty()) return;
  std::vector<double> values = cut(inner_, points);
  Int3 extent = extents(inner_);
  for (int d = 0; d < 3; ++d) values = apply(spread_[d], d, extent, values);
  for_each_row(outer_, cells, [&](std::ptrdiff_t to, std::ptrdiff_t from) {
    double* row = cells.data() + to;
    for (int i = 0; i < outer_.extent(0); ++i) row[i] += values[from + i];
  });
}

void SeparableSpread::gather(const Array3<double>& cells, Array3<double>& points) const {
  if (inner_.empty()) return;
  std::vector<double> values = cut(outer_, cells);
  Int3 extent = extents(outer_);
  for (int d = 2; d >= 0; --d) values = apply(gather_[d], d, extent, values);
  for_each_row(inner_, points, [&](std::ptrdiff_t to, std::ptrdiff_t from) {
    std::copy_n(values.data() + from, inner_.extent(0), points.data() + to);
  });
}

}  // namespace gasgrain
