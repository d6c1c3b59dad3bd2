// The implicit momentum equation of one component on its faces, per volume:
//
//   rho eps (u - u_n)/dt + sum over the six sides of F_in (u - u_up) / h
//     = - eps dp'/dx - K u + S + div(eps tau) + eps f
//
// eps, K and S of a face are means of its two cells. F_in >= 0 is the mass flux that enters through
// a side of the face's control volume and u_up what it carries.
//
// This is the conservative form d(eps rho u)/dt + div(F u) less u [d(eps rho)/dt + div F]: the same
// while the fluxes F obey continuity (they are those of the last projection), and uniform flow is
// its solution whatever eps does in space and time. All its coefficients are positive for any step,
// so that no Courant number makes it unstable. F on a side of the control volume is the mean of the
// two mass fluxes beside it.
//
// u_up is first-order upwind and implicit; with "tvd" what the limiter adds is taken from u_n. The
// stress is tau = mu (grad u + grad u^T - 2/3 div u), its terms in the component's own derivatives
// implicit, the others from u_n. f is gravity along periodic axes (see hydrostatic.h).
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/gas_state.h"
#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/momentum/row.h"

namespace gasgrain {

class MomentumAssembly {
 public:
  MomentumAssembly(const Domain& domain, const GasInput& input);

  // Rows of one component; velocity and pressure are those of the step's beginning.
  void assemble(const GasState& state, int component, double step,
                const std::vector<InflowFace>& inflow, Array3<MomentumRow>& rows);

 private:
  void inner_rows(const GasState& state, int component, double step, Array3<MomentumRow>& rows);
  void limited_convection(const GasState& state, int component);
  void outlet_rows(const GasState& state, int side, double step, Array3<MomentumRow>& rows) const;
  void close_sides(int component, Array3<MomentumRow>& rows) const;
  void add_jets(const GasState& state, int component, const std::vector<InflowFace>& inflow,
                Array3<MomentumRow>& rows) const;

  const Domain& domain_;
  double density_;
  double viscosity_;
  bool limited_;
  Sides sides_;
  Vec3 body_force_;
  Vec3 spacing_;
  Array3<double> face_void_fraction_;
  Array3<double> addition_;  // of the limiter to a flux [Pa/m]
  Array3<double> gain_;      // of a control volume by these [N/m3]; 0 for upwind
};

}  // namespace gasgrain
