// Central differences: u_face = (u_U + u_D) / 2 (Alobaid 2013, eq. 6.24 on a uniform grid). Second
// order, without numerical viscosity; wiggles where the cell Reynolds number rho |u| h / mu is
// above 2 and a gradient is steep.
#pragma once

namespace gasgrain {

struct ConvectionCentral {
  [[nodiscard]] double addition(double, double upwind, double downwind) const {
    return 0.5 * (downwind - upwind);
  }
};

}  // namespace gasgrain
