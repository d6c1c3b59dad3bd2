// Rate of strain at the centre of a cell, from the velocities of faces.
//
//   |S|^2 = 2 S'_ij S'_ij,  S' = (grad u + grad u^T)/2 - (div u)/3
//
// [1/s2]. A derivative of a component along its own axis is the difference of the cell's two faces;
// one across is the mean of the central differences at these two faces. Second order; exact for
// linear fields; zero for rotation. Beside a wall the mirrored layers (boundary/ghosts.h) make the
// difference that between the cell's outer edge and the wall.
//
// The papers write S_ij for gas of div u = 0. Between grains whose void fraction changes div u is
// not 0; the isotropic part is left off, as in the stress: swelling alone is no shear.
#pragma once

#include "gas_solver/grid/gas_state.h"

namespace gasgrain {

class StrainRate {
 public:
  StrainRate(const CellVector& velocity, const Vec3& spacing) : per_h_(spacing.cwiseInverse()) {
    for (int d = 0; d < 3; ++d) {
      u_[d] = velocity[d].data();
      s_[d] = velocity[d].stride(d);
    }
  }

  // At the cell at offset o.
  [[nodiscard]] double squared(std::ptrdiff_t o) const {
    std::array<double, 3> along;
    double sum = 0;
    for (int a = 0; a < 3; ++a) {
      along[a] = per_h_[a] * (u_[a][o + s_[a]] - u_[a][o]);
      for (int b = 0; b < a; ++b) {
        // 2 sum of squares - 2/3 square of the sum, in a form that round-off leaves >= 0.
        const double difference = along[a] - along[b];
        const double shear = across(a, b, o) + across(b, a, o);
        sum += 2.0 / 3.0 * difference * difference + shear * shear;
      }
    }
    return sum;
  }

 private:
  // d u_a / d x_b
  [[nodiscard]] double across(int a, int b, std::ptrdiff_t o) const {
    const double* u = u_[a];
    const std::ptrdiff_t hi = o + s_[a];
    return 0.25 * per_h_[b] * (u[o + s_[b]] - u[o - s_[b]] + u[hi + s_[b]] - u[hi - s_[b]]);
  }

  std::array<const double*, 3> u_;
  std::array<std::ptrdiff_t, 3> s_;
  Vec3 per_h_;
};

}  // namespace gasgrain
