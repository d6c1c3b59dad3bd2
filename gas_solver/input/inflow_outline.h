// The outline of an [[inflow]]: shape, center, size, diameter.
#pragma once

#include <string>

#include "coupling/base/toml_input.h"
#include "gas_solver/boundary/inflow_shape.h"

namespace gasgrain {

// `side`: the rectangle of the whole side that the patch lies in. What is at fault becomes an
// outline without area, which clashes with nothing.
Outline read_outline(InputTable& table, const Rectangle& side);

// Whether one rectangle lies in another, but for round-off.
bool contains(const Rectangle& outer, const Rectangle& inner);
// 'x 0 to 0.15, y 0 to 0.02 m'
std::string extent_text(const Rectangle& rectangle, int side);

}  // namespace gasgrain
