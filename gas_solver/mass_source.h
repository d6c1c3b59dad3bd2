// Gas that appears or disappears in boxes: [[mass_source]] of gas.toml as a field.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/domain.h"

namespace gasgrain {

// S_m [kg/(m3 s)] over the own cells. The rate of a box is spread evenly over its part inside the
// grid; a cell takes the share that it has in common with the box.
Array3<double> mass_source_field(const Domain& domain, const std::vector<MassSource>& sources);

}  // namespace gasgrain
