// A linear map of fields that works along the three axes one after the other: from a box of points
// to a box of cells, and its adjoint back.
//
//   outer(i, j, k) += sum over a, b, c of X(i, a) Y(j, b) Z(k, c) inner(a, b, c)
//   inner(a, b, c)  = sum over i, j, k of X(i, a) Y(j, b) Z(k, c) outer(i, j, k)
//
// Void-fraction methods whose particles touch too many cells to list them use it: a particle is
// given to a few points, and the points to cells.
#pragma once

#include <array>
#include <vector>

#include "coupling/base/array3.h"

namespace gasgrain {

// Indices lo <= i < hi.
struct IndexRange {
  int lo = 0;
  int hi = 0;
  [[nodiscard]] int extent() const { return hi - lo; }
};

// One of X, Y, Z: the share of a point that goes to a cell.
struct AxisSpread {
  AxisSpread() = default;
  AxisSpread(IndexRange points, IndexRange cells)
      : inner(points),
        outer(cells),
        share(Eigen::MatrixXd::Zero(cells.extent(), points.extent())) {}
  void add(int cell, int point, double w) { share(cell - outer.lo, point - inner.lo) += w; }

  IndexRange inner;
  IndexRange outer;
  Eigen::MatrixXd share;  // outer x inner
};

class SeparableSpread {
 public:
  SeparableSpread() = default;
  explicit SeparableSpread(const std::array<AxisSpread, 3>& axes);

  // Both are sub-boxes of the arrays that are handed in.
  [[nodiscard]] const IndexBox& inner() const { return inner_; }
  [[nodiscard]] const IndexBox& outer() const { return outer_; }

  void add(const Array3<double>& points, Array3<double>& cells) const;
  // Points outside of inner() are left alone.
  void gather(const Array3<double>& cells, Array3<double>& points) const;

 private:
  // A matrix whose rows are done some at a time, with the columns that are not zero in them.
  struct Banded {
    Eigen::MatrixXd matrix;
    std::vector<IndexRange> columns;  // of each block of rows
  };
  static Banded banded(const Eigen::MatrixXd& matrix);
  static std::vector<double> apply(const Banded& map, int axis, Int3& extent,
                                   const std::vector<double>& in);

  IndexBox inner_;
  IndexBox outer_;
  std::array<Banded, 3> spread_;
  std::array<Banded, 3> gather_;
};

}  // namespace gasgrain
