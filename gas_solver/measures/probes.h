// Pressure at heights: the mean over the horizontal layer of cells that holds the height, less the
// outlet's pressure [Pa].
#pragma once

#include "gas_solver/grid/hydrostatic.h"

namespace gasgrain {

class PressureProbes {
 public:
  PressureProbes(const Domain& domain, const std::vector<double>& heights);
  // Collective.
  [[nodiscard]] std::vector<double> measure(const Array3<double>& pressure,
                                            const Hydrostatic& hydrostatic,
                                            double outlet_pressure) const;

 private:
  const Domain& domain_;
  std::vector<int> layers_;
};

}  // namespace gasgrain
