// QUICK: the parabola through two values upwind of the face and one downwind,
//   u_face = u_U + 3/8 (u_D - u_U) + 1/8 (u_U - u_UU).
// Source: B. P. Leonard, Comput. Meth. Appl. Mech. Eng. 19 (1979) 59; Alobaid (2013), eq. 6.28 to
// 6.30 with lambda_1 = 3/8, lambda_2 = 1/8 on a uniform grid. The face value is of third order; the
// scheme is of second, because the face's flux is taken at its middle. Overshoots at steps.
#pragma once

namespace gasgrain {

struct ConvectionQuick {
  [[nodiscard]] double addition(double upwind2, double upwind, double downwind) const {
    return 0.375 * (downwind - upwind) + 0.125 * (upwind - upwind2);
  }
};

}  // namespace gasgrain
