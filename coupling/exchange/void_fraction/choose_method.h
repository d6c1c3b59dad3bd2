// The void-fraction method for a scene that names none, or `auto`: from the diameter d of the
// greatest particle and the size h of the cells.
//
//   h >= sqrt(3) b on every axis, b = 2 d    trilinear   (there the kernel is trilinear itself)
//   smaller cells                            kernel 2
//
// so that nothing jumps where one takes over from the other as a grid is refined. Why these, from
// what tests/bench/void_fraction_bench.cpp measures, is in docs/exchange.md.
#pragma once

#include <string>

#include "coupling/exchange/void_fraction/methods.h"

namespace gasgrain {

struct MethodChoice {
  VoidFractionMethod method;
  std::string reason;  // a line for the user
};

// Above this many cells across a particle nothing was measured.
inline constexpr double most_cells_across = 5.0;

// Radii [m] of the smallest and the greatest particle of all ranks.
MethodChoice choose_method(double smallest_radius, double largest_radius, const BoxGrid& grid);

}  // namespace gasgrain
