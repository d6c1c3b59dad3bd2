// TVD: second order where the flow is smooth, first-order upwind at extrema, no new extrema.
//
//   u_face = u_U + psi(r) (u_D - u_U) / 2,  r = (u_U - u_UU) / (u_D - u_U),
//   psi(r) = (r + |r|) / (1 + |r|)
// Source: B. van Leer, J. Comput. Phys. 14 (1974) 361, in the form of Sweby (1984).
// With a = u_U - u_UU and b = u_D - u_U the addition to u_U is a b / (a + b) where a b > 0, else 0.
#pragma once

#include <algorithm>

namespace gasgrain {

struct ConvectionTvd {
  [[nodiscard]] double addition(double upwind2, double upwind, double downwind) const {
    const double a = upwind - upwind2;
    const double b = downwind - upwind;
    // max(a b, 0) / (a + b) without a branch and without 0 / 0.
    constexpr double nearly_zero = 1e-290;
    const double sum = a + b;
    return std::max(a * b, 0.0) * sum / (sum * sum + nearly_zero);
  }
};

}  // namespace gasgrain
