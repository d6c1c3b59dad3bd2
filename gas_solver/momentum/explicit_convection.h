// What a convection scheme adds to first-order upwind, taken from known velocities: the net gain of
// momentum of each control volume [N/m3].
#pragma once

#include "gas_solver/boundary/inflow.h"
#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class ExplicitConvection {
 public:
  ExplicitConvection(const Domain& domain, const GasInput& input);

  // For the inner faces of a component. Faces of inflow keep upwind: what a patch brings is its own
  // momentum, see add_jets().
  void evaluate(const CellVector& flux, const Array3<double>& velocity, int component,
                const std::vector<InflowFace>& inflow);
  [[nodiscard]] const Array3<double>& gain() const { return gain_; }  // 0 for upwind

 private:
  template <class Scheme>
  [[gnu::noinline]] void evaluate(const Scheme& scheme, const CellVector& flux,
                                  const Array3<double>& velocity, int component,
                                  const std::vector<InflowFace>& inflow);

  const Domain& domain_;
  ConvectionScheme scheme_;
  Array3<double> addition_;  // to a flux through the low side of a control volume [Pa/m]
  Array3<double> gain_;
};

// Mass flux through the low side, along any axis, of the control volume of the face at `o`; `s` is
// the stride along the component's own axis.
inline double side_flux(const double* flux, std::ptrdiff_t o, std::ptrdiff_t s) {
  return 0.5 * (flux[o - s] + flux[o]);
}

}  // namespace gasgrain
