// What a side of the domain does to the gas, as the solver's loops ask for it. A kind is one header
// with one constant of this type, and one line in kinds.h.
#pragma once

#include <string_view>

namespace gasgrain {

struct BoundaryKind {
  std::string_view name;  // in gas.toml
  // The normal velocity of the face is given (0, or an inflow patch's); else it is an unknown and
  // the pressure of the face is given.
  bool normal_velocity_given;
  // Velocity along the side at the side itself: 0 (it sticks), or as in the cell (no shear).
  bool sticks;
  // The two sides of the axis are one; the solver then has no side there at all.
  bool periodic;
};

}  // namespace gasgrain
