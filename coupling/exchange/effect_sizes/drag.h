// Size of the drag, by the scene's law.
//
//   F = K U;   number: F / (m g), 1 of a grain that the gas just carries
//
// Source: the laws of drag/models.h. Inputs: K U. Exact.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeDrag {
  static constexpr std::string_view name = "drag";
  static constexpr std::string_view number_name = "K U / (m g)";
  static constexpr std::string_view threshold =
      "none: a grain in gas has it; thesis 5.3: always taken into account";

  static double number(const Scales& at) { return ratio(at.drag, at.weight()); }
  static double force(const Scales& at) { return at.drag; }
};

}  // namespace gasgrain
