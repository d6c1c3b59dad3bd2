// Gradient of the velocity at the centre of a cell, from the velocities of faces.
//
// A derivative of a component along its own axis is the difference of the cell's two faces; one
// across is the mean of the central differences at these two faces. Second order; exact for linear
// fields. Beside a wall it is what the layers outside make it (boundary/ghosts.h): mirrored ones
// make the difference that between the cell's outer edge and the wall, exact for linear fields;
// parabolic ones make it second order.
#pragma once

#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class VelocityGradient {
 public:
  VelocityGradient(const CellVector& velocity, const Vec3& spacing)
      : per_h_(spacing.cwiseInverse()) {
    for (int d = 0; d < 3; ++d) {
      u_[d] = velocity[d].data();
      s_[d] = velocity[d].stride(d);
    }
  }

  // d u_a / d x_a at the cell at offset o.
  [[nodiscard]] double along(int a, std::ptrdiff_t o) const {
    return per_h_[a] * (u_[a][o + s_[a]] - u_[a][o]);
  }
  // d u_a / d x_b, of two axes
  [[nodiscard]] double across(int a, int b, std::ptrdiff_t o) const {
    const double* u = u_[a];
    const std::ptrdiff_t hi = o + s_[a];
    return 0.25 * per_h_[b] * (u[o + s_[b]] - u[o - s_[b]] + u[hi + s_[b]] - u[hi - s_[b]]);
  }

 private:
  std::array<const double*, 3> u_;
  std::array<std::ptrdiff_t, 3> s_;
  Vec3 per_h_;
};

}  // namespace gasgrain
