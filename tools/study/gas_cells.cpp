#include "tools/study/gas_cells.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"

namespace gasgrain {

GasCells::GasCells(const SceneCopy& scene) {
  const auto lo = scene.gas_numbers("grid.lo");
  const auto hi = scene.gas_numbers("grid.hi");
  const auto counts = scene.gas_numbers("grid.cells");
  if (lo.size() != size.size() || hi.size() != size.size() || counts.size() != size.size())
    fail("{}: [grid] must have lo, hi and cells, three numbers each.", scene.gas_path());
  for (std::size_t d = 0; d < size.size(); ++d) {
    size[d] = hi[d] - lo[d];
    cells[d] = static_cast<int>(counts[d]);
  }
}

GasCells GasCells::times(double factor) const {
  GasCells other = *this;
  for (int& n : other.cells)
    if (n > 1) n = std::max(1, static_cast<int>(std::lround(n * factor)));
  return other;
}

double GasCells::count() const {
  return static_cast<double>(cells[0]) * cells[1] * cells[2];
}

double GasCells::cell_size() const {
  return std::cbrt(size[0] * size[1] * size[2] / count());
}

std::string GasCells::text() const {
  return fmt::format("[{}, {}, {}]", cells[0], cells[1], cells[2]);
}

}  // namespace gasgrain
