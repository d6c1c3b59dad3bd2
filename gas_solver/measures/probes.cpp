#include "gas_solver/measures/probes.h"

#include <algorithm>

namespace gasgrain {

PressureProbes::PressureProbes(const Domain& domain, const std::vector<double>& heights)
    : domain_(domain) {
  for (const double z : heights)
    layers_.push_back(std::clamp(domain.grid().cell_of(z, 2), 0, domain.grid().cells[2] - 1));
}

std::vector<double> PressureProbes::measure(const Array3<double>& pressure,
                                            const Hydrostatic& hydrostatic,
                                            double outlet_pressure) const {
  std::vector<double> means;
  const Int3& cells = domain_.grid().cells;
  for (const int k : layers_) {
    IndexBox layer = domain_.grid().all();
    layer.lo[2] = k;
    layer.hi[2] = k + 1;
    double sum = 0;
    for_each_cell(intersection(domain_.own(), layer), [&](int i, int j, int n) {
      sum += pressure(i, j, n) + hydrostatic.pressure(i, j, n) - outlet_pressure;
    });
    means.push_back(sum / (static_cast<double>(cells[0]) * cells[1]));
  }
  if (!means.empty()) domain_.comm().sum_in_place(means);
  return means;
}

}  // namespace gasgrain
