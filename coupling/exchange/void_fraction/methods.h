// The LIST of void-fraction methods. A new one is a header beside the others and a line here; the
// property tests then cover it.
//
// A method is a struct with a `name`, its `greatest_jump`, `reach(radius, h)` and
//   template <class F>
//   static void for_each_weight(const TileFrame&, const Vec3& x, double radius, F&& f)
// that calls f(i, j, k, w) for each cell the particle touches, any number of them, in unwrapped
// indices; the weights of a particle sum to 1 to round-off wherever it is.
#pragma once

#include <variant>

#include "coupling/exchange/choice_list.h"
#include "coupling/exchange/void_fraction/centre.h"
#include "coupling/exchange/void_fraction/exact.h"
#include "coupling/exchange/void_fraction/offset.h"
#include "coupling/exchange/void_fraction/trilinear.h"

namespace gasgrain {

using VoidFractionMethod =
    std::variant<VoidFractionCentre, VoidFractionOffset, VoidFractionTrilinear, VoidFractionExact>;

// Cells beyond a particle's own cell that the method may touch: what a rank's tile is grown by.
inline int stencil_reach(const VoidFractionMethod& method, double radius, const BoxGrid& grid) {
  const double h = grid.spacing().minCoeff();
  return std::visit([&](const auto& chosen) { return chosen.reach(radius, h); }, method);
}

}  // namespace gasgrain
