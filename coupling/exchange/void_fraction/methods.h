// The LIST of void-fraction methods. A new one is a header beside the others and a line here; the
// property tests then cover it.
//
// A method is a struct with a `name`, its `greatest_jump`, `reach(grid, axis, radius)` and
//   template <class F>
//   void for_each_weight(const TileFrame&, const Vec3& x, double radius, F&& f)
// that calls f(i, j, k, w) for each cell the particle touches, any number of them, in unwrapped
// indices; the weights of a particle sum to 1 to round-off wherever it is.
//
// A method whose particles touch too many cells to list them calls f for a few points instead, and
// has `points(grid, axis, radius, cells)`, the points of a range of cells, and `spread(grid, axis,
// radius, points)`, which gives each point to cells (separable_spread.h), with shares that sum to
// 1. What it needs of the particles' size is then the same for all of them.
#pragma once

#include <type_traits>
#include <variant>

#include "coupling/base/choice_list.h"
#include "coupling/exchange/void_fraction/centre.h"
#include "coupling/exchange/void_fraction/exact.h"
#include "coupling/exchange/void_fraction/kernel.h"
#include "coupling/exchange/void_fraction/offset.h"
#include "coupling/exchange/void_fraction/particle_grid.h"
#include "coupling/exchange/void_fraction/trilinear.h"

namespace gasgrain {

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_VOID_FRACTION_METHODS
#define GASGRAIN_VOID_FRACTION_METHODS                                              \
  VoidFractionCentre, VoidFractionOffset, VoidFractionTrilinear, VoidFractionExact, \
      VoidFractionKernel, VoidFractionParticleGrid
#endif
using VoidFractionMethod = std::variant<GASGRAIN_VOID_FRACTION_METHODS>;

template <class Method, class = void>
struct Spreads : std::false_type {};
template <class Method>
struct Spreads<Method, std::void_t<decltype(&Method::spread)>> : std::true_type {};

// Cells beyond a particle's own cell that the method may touch along each axis: what a rank's tile
// is grown by.
inline Int3 stencil_reach(const VoidFractionMethod& method, double radius, const BoxGrid& grid) {
  Int3 cells{};
  for (int d = 0; d < 3; ++d)
    cells[d] =
        std::visit([&](const auto& chosen) { return chosen.reach(grid, d, radius); }, method);
  return cells;
}

// The method with the one diameter [m] that it is to use from now on, if it uses one: all ranks and
// all steps must have the same.
inline VoidFractionMethod with_diameter(VoidFractionMethod method, double diameter) {
  std::visit(
      [&](auto& chosen) {
        if constexpr (Spreads<std::decay_t<decltype(chosen)>>::value) chosen.diameter = diameter;
      },
      method);
  return method;
}

}  // namespace gasgrain
