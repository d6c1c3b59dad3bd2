// The cells of a grid dealt out in layers across one axis, whole layers to a rank, and the way of
// fields between the boxes of the gas ranks and these slabs.
#pragma once

#include <vector>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

class Slabs {
 public:
  // `thickness` layers a rank, in the order of ranks; the last ranks may have fewer, or none.
  Slabs(const Domain& domain, int axis, int thickness);

  [[nodiscard]] int layers() const { return layers_; }  // of this rank

  // Layer after layer of this rank's, each with the first of plane_axes(axis) fastest. Collective.
  void gather(const Array3<double>& cells, double* slab);
  // Back, into the own cells. Collective.
  void scatter(const double* slab, Array3<double>& cells);

 private:
  [[nodiscard]] std::ptrdiff_t place(int i, int j, int k) const {
    return i * stride_[0] + j * stride_[1] + k * stride_[2] - origin_;
  }

  const Domain& domain_;
  std::array<std::ptrdiff_t, 3> stride_;  // in the slab
  std::ptrdiff_t origin_;
  int layers_;
  // Parts of the own box that lie in each rank's slab, and of the own slab in each rank's box.
  std::vector<IndexBox> of_box_, of_slab_;
  std::vector<int> box_counts_, box_starts_, slab_counts_, slab_starts_;
  std::vector<double> in_boxes_, in_slabs_;  // on the way; empty on one rank
};

}  // namespace gasgrain
