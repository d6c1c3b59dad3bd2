// How collective effects add up what the parcels of a cell deposit when several ranks share it.
#pragma once

#include <functional>
#include <vector>

#include "coupling/base/array3.h"

namespace gasgrain {

// Adds the fields, all over the rank's tile, in place over the ranks whose tiles hold the same
// cells; collective. On one rank with walls all around it leaves them as they are.
using SumOverRanks = std::function<void(const std::vector<Array3<double>*>&)>;

}  // namespace gasgrain
