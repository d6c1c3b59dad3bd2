// The pressure correction dp that gives the predicted velocity u* continuity,
//   u = u* - w grad dp,   d(eps rho)/dt + div(eps rho u) = S_m.
//
// The projection takes w = a / (rho eps / dt + theta K), a = eps in model A and 1 in model B. Drag
// is in w: the corrected velocity is the one that the drag of the momentum balance acts on,
//   rho eps (u - u_n)/dt + convection(u*) = -a grad (p + dp) - K u + S + ...,
// exactly, however stiff K is. SIMPLE and SIMPLEC take w from the rows of the momentum equation.
//
// The density of an ideal gas rises by dp M / (R T) (a Helmholtz equation); the fluxes eps rho u of
// a correction carry the density before it, so that the mass stored is exactly the mass that came.
#pragma once

#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/pressure/mass_flux.h"
#include "gas_solver/pressure/pressure_solver.h"

namespace gasgrain {

struct ProjectionReport {
  int iterations = 0;
  // Greatest of a cell, relative to the gas that flows through: what the predicted velocity lacks
  // of continuity, and what the corrected one does.
  double mass_defect = 0;
  double continuity_residual = 0;
  // Inflow + sources - outflow - storage of the whole grid, relative to the same.
  double mass_imbalance = 0;
  SideFlows sides;
};

class Projection {
 public:
  Projection(const Domain& domain, const GasInput& input, Halo& halo);

  // state.velocity is u* before, u after; pressure, density and mass fluxes follow. `mobility`: w
  // on the faces, or empty for that of the projection. Collective.
  ProjectionReport project(GasState& state, double step, const std::vector<InflowFace>& inflow,
                           const CellVector& mobility);

  // The mass fluxes of a state that comes from elsewhere.
  void update_fluxes(GasState& state, const std::vector<InflowFace>& inflow) {
    flux_.update(state, inflow);
  }
  // What the solver learnt in earlier steps is forgotten: the next step is that of a new run.
  void forget() { solver_.forget(); }

 private:
  // The faces of an axis that a pressure gradient moves, o being the face's offset:
  // at_inner(o, w, density) between two cells, at_outlet(o, w, density, cell inside, outward =
  // +-1).
  template <class InnerFace, class OutletFace>
  void for_each_moved_face(const GasState& state, double step, int axis, const CellVector& mobility,
                           InnerFace&& at_inner, OutletFace&& at_outlet);
  void set_coefficients(const GasState& state, double step, const CellVector& mobility);
  // Mass that each cell lacks [kg/s].
  void set_source(const GasState& state, double step);
  [[nodiscard]] double greatest_source() const;
  void correct(GasState& state, double step, const CellVector& mobility);
  void compress(GasState& state);
  [[nodiscard]] double flow_scale(const GasState& state, double step, double inflow) const;

  const Domain& domain_;
  Walls walls_;
  double density_;
  double compressibility_;
  double theta_;
  bool whole_gradient_;
  double relax_pressure_ = 1.0;
  double tolerance_;
  Vec3 spacing_;
  Halo& halo_;
  MassFlux flux_;
  PressureSystem system_;
  PressureSolver solver_;
};

}  // namespace gasgrain
