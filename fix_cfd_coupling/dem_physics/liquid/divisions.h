// The LIST of divisions of a broken bridge's liquid. A new one is a header beside the others and a
// line here; the tests then cover it. A division is a struct with `name`, `source` and
//   static Division divide(const BrokenBridge&)
// whose two volumes are never negative and sum to the bridge's to round-off.
#pragma once

#include <variant>

#include "fix_cfd_coupling/dem_physics/liquid/even.h"
#include "fix_cfd_coupling/dem_physics/liquid/own_share.h"
#include "fix_cfd_coupling/dem_physics/liquid/shi_mccarthy.h"

namespace gasgrain::liquid {

using DivisionRule = std::variant<DivisionEven, DivisionOwnShare, DivisionShiMcCarthy>;

}  // namespace gasgrain::liquid
