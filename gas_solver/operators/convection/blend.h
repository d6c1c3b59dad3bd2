// A fixed mixture of upwind and central differences: u_face = alpha u_U + (1 - alpha) (u_U + u_D) /
// 2 with alpha the share of upwind. First order, its error alpha times that of upwind. Source:
// Alobaid (2013), eq. 6.27. Deviation: the central part there is printed as a gradient times the
// distance from the cell's centre, without the cell's own value; taken as the linear interpolation
// it stands for.
#pragma once

namespace gasgrain {

struct ConvectionBlend {
  double upwind_share = 0.5;
  [[nodiscard]] double addition(double, double upwind, double downwind) const {
    return (1.0 - upwind_share) * 0.5 * (downwind - upwind);
  }
};

}  // namespace gasgrain
