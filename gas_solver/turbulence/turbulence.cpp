#include "gas_solver/turbulence/turbulence.h"

#include "coupling/base/error.h"

namespace gasgrain {

Turbulence::Turbulence(const Domain& domain, const GasInput& input, Halo& halo)
    : model_(chosen(domain, input, halo)) {}

Turbulence::Models Turbulence::chosen(const Domain& domain, const GasInput& input, Halo& halo) {
  switch (input.turbulence.model) {
    case TurbulenceModel::smagorinsky:
      return listed<Models>([&] { return Smagorinsky(domain, input, halo); });
    case TurbulenceModel::k_epsilon:
      return listed<Models>([&] { return KEpsilon(domain, input, halo); });
    case TurbulenceModel::none:
      break;
  }
  fail("[turbulence] model = \"none\" has nothing to compute.");
}

TurbulenceReport Turbulence::update(const GasState& state, double step,
                                    const std::vector<InflowFace>& inflow) {
  return std::visit([&](auto& m) { return m.update(state, step, inflow); }, model_);
}

}  // namespace gasgrain
