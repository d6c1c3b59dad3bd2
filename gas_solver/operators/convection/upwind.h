// First-order upwind: u_face = u_U (Alobaid 2013, eq. 6.23). Bounded at any step; its error is that
// of an additional viscosity rho |u| h / 2.
#pragma once

namespace gasgrain {

struct ConvectionUpwind {
  [[nodiscard]] double addition(double, double, double) const { return 0.0; }
};

}  // namespace gasgrain
