// The implicit momentum equation of one component on its faces, per volume:
//
//   rho eps (u - u_n)/dt + sum over the six sides of F_in (u - u_up) / h
//     = - a (dp'/dx - rho' g) - K u + S + div(eps tau) + eps rho f
//
// a = eps in model A, 1 in model B. eps, rho, K and S of a face are means of its two cells. F_in >=
// 0 is the mass flux that enters through a side of the face's control volume and u_up what it
// carries. rho' is what an ideal gas weighs more than gas at rest, f gravity along periodic axes
// (see hydrostatic.h).
//
// This is the conservative form d(eps rho u)/dt + div(F u) less u [d(eps rho)/dt + div F]: the same
// while the fluxes F obey continuity (they are those of the last projection), and uniform flow is
// its solution whatever eps does in space and time. All its coefficients are positive for any step,
// so that no Courant number makes it unstable. F on a side of the control volume is the mean of the
// two mass fluxes beside it. Gas that appears (S_m) brings no momentum: S_m u is taken from the
// right-hand side. Gas that disappears takes its velocity along.
//
// u_up is first-order upwind and implicit; what a scheme of higher order adds is taken from the
// velocities `lagged` (explicit). The stress is tau = mu (grad u + grad u^T - 2/3 div u), its terms
// in the component's own derivatives implicit, the others from `lagged`.
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/hydrostatic.h"
#include "gas_solver/momentum/explicit_convection.h"
#include "gas_solver/momentum/momentum_step.h"
#include "gas_solver/momentum/side_rows.h"
#include "gas_solver/operators/quantity.h"
#include "gas_solver/turbulence/turbulence.h"

namespace gasgrain {

class MomentumAssembly {
 public:
  MomentumAssembly(const Domain& domain, const GasInput& input);

  // Rows of one component, without inertia: see finish_rows.h. The pressure is the state's.
  // `turbulence`: null where none is named.
  void assemble(const GasState& state, int component, const CellVector& lagged,
                const std::vector<InflowFace>& inflow, const Turbulence* turbulence,
                Array3<MomentumRow>& rows);

  // eps of the component's inner faces of the last assemble().
  [[nodiscard]] const Array3<double>& face_void_fraction() const { return face_void_fraction_; }

 private:
  template <class Density, class Viscosity>
  void inner_rows(const GasState& state, int component, const CellVector& lagged,
                  const Density& density, const Viscosity& viscosity, Array3<MomentumRow>& rows);
  void add_mass_sources(const GasState& state, int component, Array3<MomentumRow>& rows) const;

  const Domain& domain_;
  double density_;
  double viscosity_;
  bool whole_gradient_;  // model B
  SideRows sides_;
  Vec3 gravity_at_rest_;
  Vec3 gravity_body_;
  double compressibility_;
  Vec3 spacing_;
  ExplicitConvection convection_;
  Array3<double> face_void_fraction_;
};

}  // namespace gasgrain
