#include "gas_solver/momentum/explicit_convection.h"

#include <algorithm>

namespace gasgrain {

ExplicitConvection::ExplicitConvection(const Domain& domain, const GasInput& input)
    : domain_(domain),
      scheme_(convection_scheme(input.convection, input.blend)),
      gain_(domain.box()) {
  if (input.convection != Convection::upwind) addition_ = Array3<double>(domain.box());
}

void ExplicitConvection::evaluate(const CellVector& flux, const Array3<double>& velocity,
                                  int component, const std::vector<InflowFace>& inflow) {
  std::visit([&](const auto& scheme) { evaluate(scheme, flux, velocity, component, inflow); },
             scheme_);
}

template <class Scheme>
void ExplicitConvection::evaluate(const Scheme& scheme, const CellVector& flux,
                                  const Array3<double>& velocity, int component,
                                  const std::vector<InflowFace>& inflow) {
  if constexpr (std::is_same_v<Scheme, ConvectionUpwind>) return;
  const double* const u = velocity.data();
  const std::ptrdiff_t s = gain_.stride(component);
  const IndexBox faces = domain_.inner_faces(component);
  double* const addition = addition_.data();
  double* const gain = gain_.data();
  gain_.fill(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double* const through = flux[axis].data();
    const std::ptrdiff_t t = gain_.stride(axis);
    const double per_h = 1.0 / domain_.grid().spacing()[axis];
    IndexBox lows = faces;
    ++lows.hi[axis];  // the high sides of the last
    for (int k = lows.lo[2]; k < lows.hi[2]; ++k)
      for (int j = lows.lo[1]; j < lows.hi[1]; ++j) {
        const std::ptrdiff_t first = gain_.offset(lows.lo[0], j, k);
        const std::ptrdiff_t end = first + lows.extent(0);
        // Both directions of flow are computed, one of them times 0: cheaper than a branch.
        for (std::ptrdiff_t o = first; o < end; ++o) {
          const double f = side_flux(through, o, s) * per_h;
          addition[o] = std::max(f, 0.0) * scheme.addition(u[o - 2 * t], u[o - t], u[o]) +
                        std::min(f, 0.0) * scheme.addition(u[o + t], u[o], u[o - t]);
        }
      }
    if (axis == component)
      for (const InflowFace& face : inflow)
        if (axis_of(face.side) == component)
          addition[gain_.offset(face.face[0], face.face[1], face.face[2]) +
                   (is_high(face.side) ? 0 : t)] = 0.0;
    for (int k = faces.lo[2]; k < faces.hi[2]; ++k)
      for (int j = faces.lo[1]; j < faces.hi[1]; ++j) {
        const std::ptrdiff_t first = gain_.offset(faces.lo[0], j, k);
        const std::ptrdiff_t end = first + faces.extent(0);
        for (std::ptrdiff_t o = first; o < end; ++o) gain[o] += addition[o] - addition[o + t];
      }
  }
}

}  // namespace gasgrain
