// Each side takes back the share of a broken bridge's liquid that it gave.
//
//   V_i = V g_i / (g_i + g_j)
//
// Source: Muguruma, Tanaka and Tsuji, Powder Technol. 109 (2000) 49; Alobaid (2013), 5.1.2.2.3.
// Assumes: liquid does not cross from grain to grain. When the bridge has lost or taken up liquid
//   meanwhile both bear it in proportion. A bridge to which nobody gave is halved.
#pragma once

#include <string_view>

#include "fix_cfd_coupling/dem_physics/liquid/broken_bridge.h"

namespace gasgrain::liquid {

struct DivisionOwnShare {
  static constexpr std::string_view name = "own_share";
  static constexpr std::string_view source = "Muguruma, Tanaka and Tsuji (2000)";

  static Division divide(const BrokenBridge& b) {
    const double given = b.i.given + b.j.given;
    return divide_by_share(b.volume, given > 0.0 ? b.i.given / given : 0.5);
  }
};

}  // namespace gasgrain::liquid
