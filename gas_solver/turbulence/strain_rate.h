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
    double normal = 0;
    double divergence = 0;
    double shear = 0;
    for (int a = 0; a < 3; ++a) {
      const double g = per_h_[a] * (u_[a][o + s_[a]] - u_[a][o]);
      normal += g * g;
      divergence += g;
      for (int b = 0; b < a; ++b) {
        const double sum = across(a, b, o) + across(b, a, o);
        shear += sum * sum;
      }
    }
    return 2.0 * normal - 2.0 / 3.0 * divergence * divergence + shear;
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
