// Makes rows of the terms in space, R u = sum of c u_neighbour + source, into those of a step of
// time, each divided by its diagonal:
//
//   m (u - u_n) + theta (R u - sum of c u_nb) + (1 - theta) (R u_n - sum of c u_nb,n) = source,
//   m = rho eps / dt; theta = 1 is implicit Euler, 1/2 Crank-Nicolson (drag included).
//
// An outer iteration relaxes the change of its iterate u_k by alpha: the diagonal D becomes
// D / alpha, and (1 - alpha) / alpha D u_k joins the source (Patankar 1980, section 4.5).
#pragma once

#include "gas_solver/gas_input.h"
#include "gas_solver/grid/halo.h"
#include "gas_solver/momentum/momentum_step.h"
#include "gas_solver/momentum/row.h"

namespace gasgrain {

class RowFinish {
 public:
  RowFinish(const Domain& domain, const GasInput& input);

  // `face_void_fraction`: of the inner faces.
  void finish(const GasState& state, int component, const MomentumStep& step,
              const Array3<double>& face_void_fraction, Array3<MomentumRow>& rows);

  // What a pressure gradient changes the velocity by, w = a / D' [m3 s/kg] on the unknown faces:
  // D' = D for SIMPLE, D less the coefficients of the neighbours for SIMPLEC. Empty for the
  // projection, which needs neither. share_mobility() fills the faces that other ranks hold.
  [[nodiscard]] const CellVector& mobility() const { return mobility_; }
  void share_mobility(Halo& halo);

 private:
  // `mass`: m of a face; `share`: a of a face.
  template <class Mass, class Share>
  void finish_faces(const IndexBox& faces, int component, const GasState& state,
                    const MomentumStep& step, const Mass& mass, const Share& share,
                    Array3<MomentumRow>& rows);

  const Domain& domain_;
  Sides sides_;
  double density_;
  double theta_;
  double relax_ = 1.0;
  bool whole_gradient_;
  PressureVelocity method_;
  CellVector mobility_;
};

// Share of the step's end in its terms.
inline double time_weight(TimeScheme scheme) {
  return scheme == TimeScheme::crank_nicolson ? 0.5 : 1.0;
}

}  // namespace gasgrain
