#include "gas_solver/grid/hydrostatic.h"

#include <cmath>

namespace gasgrain {

Hydrostatic::Hydrostatic(const GasInput& input)
    : grid_(input.grid),
      density_(input.density),
      compressibility_(input.law == GasLaw::ideal_gas
                           ? input.molar_mass / (gas_constant * input.temperature)
                           : 0.0),
      reference_pressure_(input.reference_pressure),
      outlet_pressure_(input.outlet_pressure) {
  for (int d = 0; d < 3; ++d) {
    (grid_.periodic[d] ? gravity_body_ : gravity_at_rest_)[d] = input.gravity[d];
    reference_[d] = 0.5 * (grid_.lo[d] + grid_.hi[d]);
    const double a = compressibility_ * gravity_at_rest_[d] * grid_.spacing()[d];
    growth_[d] = (1 + 0.5 * a) / (1 - 0.5 * a);
  }
  int side = side_of(2, true);
  for (int n = side_count - 1; n >= 0; --n)
    if (input.sides[n] == &outlet) side = n;
  reference_[axis_of(side)] = is_high(side) ? grid_.hi[axis_of(side)] : grid_.lo[axis_of(side)];
}

double Hydrostatic::pressure(int i, int j, int k) const {
  const Vec3 h = grid_.spacing();
  const Vec3 from_outlet = grid_.lo + h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5)) - reference_;
  if (compressibility_ == 0.0)
    return outlet_pressure_ + density_ * gravity_at_rest_.dot(from_outlet);
  double absolute = reference_pressure_ + outlet_pressure_;
  for (int d = 0; d < 3; ++d)
    if (growth_[d] != 1.0) absolute *= std::pow(growth_[d], from_outlet[d] / h[d]);
  return absolute - reference_pressure_;
}

}  // namespace gasgrain
