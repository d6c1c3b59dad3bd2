// A field over an IndexBox, addressed by GLOBAL cell index; x runs fastest in memory.
#pragma once

#include <algorithm>
#include <vector>

#include "coupling/base/box_grid.h"

namespace gasgrain {

template <class T>
class Array3 {
 public:
  Array3() = default;
  explicit Array3(const IndexBox& box, T value = T{})
      : box_(box),
        stride_y_(box.extent(0)),
        stride_z_(static_cast<std::ptrdiff_t>(box.extent(0)) * box.extent(1)),
        origin_(box.lo[0] + stride_y_ * box.lo[1] + stride_z_ * box.lo[2]),
        data_(box.size(), value) {}

  [[nodiscard]] const IndexBox& box() const { return box_; }
  [[nodiscard]] std::size_t size() const { return data_.size(); }
  [[nodiscard]] std::ptrdiff_t offset(int i, int j, int k) const {
    return i + stride_y_ * j + stride_z_ * k - origin_;
  }
  [[nodiscard]] std::ptrdiff_t stride(int axis) const {
    return axis == 0 ? 1 : (axis == 1 ? stride_y_ : stride_z_);
  }
  T& operator()(int i, int j, int k) { return data_[offset(i, j, k)]; }
  const T& operator()(int i, int j, int k) const { return data_[offset(i, j, k)]; }
  T& operator[](std::size_t n) { return data_[n]; }
  const T& operator[](std::size_t n) const { return data_[n]; }
  T* data() { return data_.data(); }
  const T* data() const { return data_.data(); }
  void fill(T value) { std::fill(data_.begin(), data_.end(), value); }
  auto begin() { return data_.begin(); }
  auto end() { return data_.end(); }
  auto begin() const { return data_.begin(); }
  auto end() const { return data_.end(); }

 private:
  IndexBox box_;
  std::ptrdiff_t stride_y_ = 0;
  std::ptrdiff_t stride_z_ = 0;
  std::ptrdiff_t origin_ = 0;
  std::vector<T> data_;
};

// Visits every cell of a box, x fastest: f(i, j, k).
template <class F>
void for_each_cell(const IndexBox& box, F&& f) {
  for (int k = box.lo[2]; k < box.hi[2]; ++k)
    for (int j = box.lo[1]; j < box.hi[1]; ++j)
      for (int i = box.lo[0]; i < box.hi[0]; ++i) f(i, j, k);
}

}  // namespace gasgrain
