#include "gas_solver/turbulence/smagorinsky.h"

#include <cmath>

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/operators/quantity.h"
#include "gas_solver/turbulence/strain_rate.h"

namespace gasgrain {

double filter_width(const BoxGrid& grid) {
  double product = 1;
  int axes = 0;
  for (int d = 0; d < 3; ++d)
    if (grid.cells[d] > 1) {
      product *= grid.spacing()[d];
      ++axes;
    }
  return axes > 0 ? std::pow(product, 1.0 / axes) : std::cbrt(grid.cell_volume());
}

Smagorinsky::Smagorinsky(const Domain& domain, const GasInput& input, Halo& halo)
    : domain_(domain),
      halo_(halo),
      molecular_(input.viscosity),
      density_(input.density),
      walls_(domain, input),
      viscosity_(domain.box(), input.viscosity) {
  const double length = input.turbulence.smagorinsky_constant * filter_width(domain.grid());
  area_ = length * length;
}

TurbulenceReport Smagorinsky::update(const GasState& state, double,
                                     const std::vector<InflowFace>&) {
  const StrainRate strain(state.velocity, domain_.grid().spacing());
  std::visit(
      [&](const auto& rho) {
        for_each_cell(domain_.own(), [&](int i, int j, int k) {
          const auto o = viscosity_.offset(i, j, k);
          viscosity_[o] = molecular_ + area_ * rho(o) * std::sqrt(strain.squared(o));
        });
      },
      quantity(state.density, density_));
  halo_.exchange({&viscosity_});
  fill_ghost_cells(domain_, viscosity_);
  return {};
}

}  // namespace gasgrain
