// What `mode overlapped` changes: grains feel the gas of one interval before.
//
//   F = K U min(1, T v / h),   number: T v / h, the part of a cell that a grain crosses meanwhile
//
// Within a cell's width the gas changes by as much as it is. Source: own; docs/coupling.md has what
// it does to a bed. Inputs: drag, interval T, v, cell h. An upper bound.
#pragma once

#include <algorithm>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeOverlapped {
  static constexpr std::string_view name = "mode overlapped";
  static constexpr std::string_view number_name = "T v / h";
  static constexpr std::string_view threshold =
      "0.05: above it the grains' gas is too old; error of first order in T (docs/coupling.md)";

  static double number(const Scales& at) { return ratio(at.interval * at.speed, at.cell); }
  static double force(const Scales& at) { return at.drag * std::min(1.0, number(at)); }
};

}  // namespace gasgrain
