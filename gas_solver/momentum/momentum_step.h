// A step of time as the momentum equation sees it.
#pragma once

#include <vector>

#include "gas_solver/boundary/inflow.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class Turbulence;

struct MomentumStep {
  double length;                          // dt [s]
  const CellVector& before;               // velocity at the step's beginning
  const std::vector<InflowFace>& inflow;  // at its end
  const Turbulence* turbulence;           // null where none is named
};

}  // namespace gasgrain
