// Half of a broken bridge's liquid to either side.
//
//   V_i = V_j = V / 2
//
// Source: Mikami, Kamiya and Horio, Chem. Eng. Sci. 53 (1998) 1927; Alobaid (2013), 5.1.2.2.3.
// Assumes: equal grains; a wall counts as one.
#pragma once

#include <string_view>

#include "fix_cfd_coupling/dem_physics/liquid/broken_bridge.h"

namespace gasgrain::liquid {

struct DivisionEven {
  static constexpr std::string_view name = "even";
  static constexpr std::string_view source = "Mikami, Kamiya and Horio (1998)";

  static Division divide(const BrokenBridge& b) { return divide_by_share(b.volume, 0.5); }
};

}  // namespace gasgrain::liquid
