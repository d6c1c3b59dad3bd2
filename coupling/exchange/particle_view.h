// Contract: what a DEM host supplies. Pointers into the host's own arrays; nothing is copied.
#pragma once

#include <Eigen/Core>

#include <cstddef>

#include "coupling/base/vec3.h"

namespace gasgrain {

// The particles (or parcels of them) that a rank owns, valid until the host re-sorts its atoms.
// Forces and records are those of one particle; what is deposited or added up counts all of a
// parcel's.
struct ParticleView {
  std::size_t count = 0;
  const double* position = nullptr;          // [m], count x 3, row by row
  const double* velocity = nullptr;          // [m/s], count x 3
  const double* angular_velocity = nullptr;  // [rad/s], count x 3; null when no effect needs it
  const double* radius = nullptr;            // [m], count
  const double* mass = nullptr;              // [kg], count
  // Parcels: how many particles of this radius and mass each entry stands for. Null: one each.
  const double* parcel_size = nullptr;

  [[nodiscard]] double N(std::size_t p) const {
    return parcel_size == nullptr ? 1.0 : parcel_size[p];
  }
  [[nodiscard]] Eigen::Map<const Vec3> x(std::size_t p) const {
    return Eigen::Map<const Vec3>(position + 3 * p);
  }
  [[nodiscard]] Eigen::Map<const Vec3> v(std::size_t p) const {
    return Eigen::Map<const Vec3>(velocity + 3 * p);
  }
};

}  // namespace gasgrain
