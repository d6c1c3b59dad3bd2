// The turbulence model that [turbulence] model names, chosen once: a run without one has no object
// of this type and no field of it.
//
// A model gives the viscosity mu + mu_t of cells and the coefficient of the stress along walls. A
// new one is a class with the members that are called here, a line in Models and one in
// turbulence.cpp.
#pragma once

#include <variant>

#include "coupling/base/listed.h"
#include "gas_solver/turbulence/k_epsilon.h"
#include "gas_solver/turbulence/smagorinsky.h"

namespace gasgrain {

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_TURBULENCE_MODELS
#define GASGRAIN_TURBULENCE_MODELS Smagorinsky, KEpsilon
#endif

class Turbulence {
 public:
  // Of a model other than none.
  Turbulence(const Domain& domain, const GasInput& input, Halo& halo);

  // Once a step, before the velocity is predicted: its layers and the last mass fluxes are filled.
  // Collective.
  TurbulenceReport update(const GasState& state, double step,
                          const std::vector<InflowFace>& inflow);

  // mu + mu_t of cells over Domain::box(), layers filled [Pa s].
  [[nodiscard]] const Array3<double>& viscosity() const {
    return std::visit(
        [](const auto& m) -> auto& { return m.viscosity(); }, model_);
  }
  // Whether walls have a law of their own; else their shear is that of the molecular viscosity.
  [[nodiscard]] bool has_wall_law() const {
    return std::visit([](const auto& m) { return m.has_wall_law; }, model_);
  }
  // Wall stress per velocity along a side the gas sticks to (relative to the side), of the layer of
  // cells inside it, [Pa s/m]: mu / (h / 2), or the wall law's. That of a face is the mean of its
  // two cells'.
  [[nodiscard]] const Array3<double>& wall_coefficient(int side) const {
    return std::visit(
        [&](const auto& m) -> auto& { return m.walls().coefficient(side); }, model_);
  }

  // For output; none of another model.
  [[nodiscard]] const KEpsilon* k_epsilon() const { return chosen_as<KEpsilon>(model_); }
  [[nodiscard]] KEpsilon* k_epsilon() { return chosen_as<KEpsilon>(model_); }

  // As in GasSolver: what a run needs to go on; restore() after it was read. Collective.
  template <class File>
  void exchange_with(File& file) {
    std::visit([&](auto& m) { m.exchange_with(file); }, model_);
  }
  void restore(const GasState& state) {
    std::visit([&](auto& m) { m.restore(state); }, model_);
  }

 private:
  using Models = std::variant<GASGRAIN_TURBULENCE_MODELS>;
  static Models chosen(const Domain& domain, const GasInput& input, Halo& halo);
  Models model_;
};

}  // namespace gasgrain
