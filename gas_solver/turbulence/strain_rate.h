// Rate of strain at the centre of a cell, from the velocities of faces.
//
//   |S|^2 = 2 S'_ij S'_ij,  S' = (grad u + grad u^T)/2 - (div u)/3
//
// [1/s2], with the gradient of operators/velocity_gradient.h. Exact for linear fields; zero for
// rotation.
//
// The papers write S_ij for gas of div u = 0. Between grains whose void fraction changes div u is
// not 0; the isotropic part is left off, as in the stress: swelling alone is no shear.
#pragma once

#include "gas_solver/operators/velocity_gradient.h"

namespace gasgrain {

class StrainRate {
 public:
  StrainRate(const CellVector& velocity, const Vec3& spacing) : gradient_(velocity, spacing) {}

  // At the cell at offset o.
  [[nodiscard]] double squared(std::ptrdiff_t o) const {
    std::array<double, 3> along;
    double sum = 0;
    for (int a = 0; a < 3; ++a) {
      along[a] = gradient_.along(a, o);
      for (int b = 0; b < a; ++b) {
        // 2 sum of squares - 2/3 square of the sum, in a form that round-off leaves >= 0.
        const double difference = along[a] - along[b];
        const double shear = gradient_.across(a, b, o) + gradient_.across(b, a, o);
        sum += 2.0 / 3.0 * difference * difference + shear * shear;
      }
    }
    return sum;
  }

 private:
  VelocityGradient gradient_;
};

}  // namespace gasgrain
