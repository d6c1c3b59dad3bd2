// Trilinear deposit of what parcels carry to cells, and the way back.
#pragma once

#include "coupling/base/array3.h"
#include "coupling/base/error.h"
#include "coupling/base/trilinear_weights.h"

namespace gasgrain {

// The cells and weights of a parcel along the three axes.
using ParcelStencil = std::array<AxisWeights, 3>;

inline void deposit(const ParcelStencil& stencil, double amount, Array3<double>& field) {
  for_each_product(stencil, [&](int i, int j, int k, double w) { field(i, j, k) += w * amount; });
}

inline double sample(const ParcelStencil& stencil, const Array3<double>& field) {
  double value = 0.0;
  for_each_product(stencil, [&](int i, int j, int k, double w) { value += w * field(i, j, k); });
  return value;
}

// Whether all cells of the stencil are in the tile.
inline bool within(const ParcelStencil& stencil, const IndexBox& tile) {
  for (int d = 0; d < 3; ++d)
    for (int n = 0; n < stencil[d].count; ++n)
      if (stencil[d].cell[n] < tile.lo[d] || stencil[d].cell[n] >= tile.hi[d]) return false;
  return true;
}

// The stencil of a parcel, or an Error where the tile does not hold it.
inline ParcelStencil stencil_within(const TileFrame& frame, const Vec3& x) {
  const ParcelStencil stencil = trilinear_axes(frame, x);
  if (!within(stencil, frame.tile))
    fail(
        "a parcel at ({:.6g}, {:.6g}, {:.6g}) m is outside of the cells that its rank holds: hand "
        "parcels to the ranks that own their places before the cells are summed.",
        x[0], x[1], x[2]);
  return stencil;
}

// A field of the frame's tile, of zeros.
inline void clear(Array3<double>& field, const TileFrame& frame) {
  if (field.box() == frame.tile && field.size() > 0)
    field.fill(0.0);
  else
    field = Array3<double>(frame.tile, 0.0);
}

}  // namespace gasgrain
