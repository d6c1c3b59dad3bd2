// Vectors of three: positions, velocities, forces (Vec3) and cell counts or indices (Int3).
#pragma once

#include <Eigen/Core>

#include <array>

namespace gasgrain {

using Vec3 = Eigen::Vector3d;
using Int3 = std::array<int, 3>;

}  // namespace gasgrain
