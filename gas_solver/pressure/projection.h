// The projection: a pressure increment dp that gives the predicted velocity u* continuity,
//   u = u* - w grad dp,   w = eps / (rho eps / dt + K),
//   d eps/dt + div(eps u) = 0.
// Drag is in w: the corrected velocity is the one that the drag of the momentum balance acts on,
//   rho eps (u - u_n)/dt + convection(u*) = -eps grad (p + dp) - K u + S + ...,
// exactly, however stiff K is.
#pragma once

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/pressure/pressure_solver.h"

namespace gasgrain {

struct ProjectionReport {
  int iterations = 0;
  double continuity_residual = 0;  // greatest of a cell, relative to the gas that flows through
  double mass_inflow = 0;          // [kg/s]
  double mass_outflow = 0;         // [kg/s], backflow counted negative
  long backflow_faces = 0;
};

class Projection {
 public:
  Projection(const Domain& domain, const GasInput& input, Halo& halo);

  // state.velocity is u* before, u after; pressure and mass fluxes follow. Collective.
  ProjectionReport project(GasState& state, double step, const std::vector<InflowFace>& inflow);

  // eps rho u from the velocity, as project() leaves it; for a state that comes from a file.
  void update_fluxes(GasState& state, const std::vector<InflowFace>& inflow);
  // What the solver learnt in earlier steps is forgotten: the next step is that of a new run.
  void forget() { solver_.forget(); }

 private:
  void set_coefficients(const GasState& state, double step);
  // Volume that each cell gains too much of [m3/s]; of what flows through a side, the total.
  void set_source(const GasState& state, double step);
  void correct(GasState& state, double step);
  double flow_scale(const GasState& state, double step, const ProjectionReport& report) const;
  void measure_sides(const GasState& state, ProjectionReport& report) const;

  const Domain& domain_;
  Sides sides_;
  double density_;
  double tolerance_;
  Vec3 spacing_;
  Halo& halo_;
  PressureSystem system_;
  PressureSolver solver_;
};

}  // namespace gasgrain
