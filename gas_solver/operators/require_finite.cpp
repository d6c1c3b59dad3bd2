#include "gas_solver/operators/require_finite.h"

#include <algorithm>
#include <cmath>

#include "gas_solver/gas_fault.h"

namespace gasgrain {

void require_finite(const Domain& domain, const GasState& state, double time) {
  const BoxGrid& grid = domain.grid();
  constexpr double none = 1e300;
  const Int3& cells = grid.cells;
  double worst = none;  // number of the first cell at fault
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    const auto o = state.pressure.offset(i, j, k);
    const double sum =
        state.pressure[o] + state.velocity[0][o] + state.velocity[1][o] + state.velocity[2][o];
    if (!std::isfinite(sum))
      worst = std::min(worst,
                       i + static_cast<double>(cells[0]) * (j + static_cast<double>(cells[1]) * k));
  });
  worst = domain.comm().min(worst);
  if (worst == none) return;
  const long number = static_cast<long>(worst);
  const Int3 at{static_cast<int>(number % cells[0]), static_cast<int>(number / cells[0] % cells[1]),
                static_cast<int>(number / cells[0] / cells[1])};
  const Vec3 x = grid.lo + grid.spacing().cwiseProduct(Vec3(at[0] + 0.5, at[1] + 0.5, at[2] + 0.5));
  throw GasFault(fmt::format(
      "the gas velocity or pressure in cell ({}, {}, {}) at x = {:.6g}, y = {:.6g}, z = {:.6g} m "
      "is not finite at t = {:.9g} s. Likely the flow has run away there, or a void fraction or "
      "drag "
      "that is not finite has come in: lower [time] step or courant_max.",
      at[0], at[1], at[2], x[0], x[1], x[2], time));
}

}  // namespace gasgrain
