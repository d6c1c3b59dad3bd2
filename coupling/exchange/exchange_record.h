// What the host stores and migrates for each particle between couplings: 13 plain doubles.
//
// Between two couplings a particle feels K (u - v) + steady_force with its own, current v. At a
// coupling the gas is charged with the drag it EXPECTS, K (u - v) over the interval with v as it
// then is; what the particle has really `taken` by the next coupling differs from it, by the carry
//   carry = taken - expected   [N s].
// The gas feels the force density -(K u - S). To lose the carry on top of what is expected of it
// over the next interval T, S must be smaller by carry / T:
//   S = K v - carry / T.
// A new particle has a record of zeros: no force until the next coupling, nothing owed.
#pragma once

#include <array>
#include <type_traits>

#include "coupling/base/vec3.h"

namespace gasgrain {

struct ExchangeRecord {
  double K = 0.0;                        // drag coefficient [kg/s], F_drag = K (u - v)
  std::array<double, 3> u{};             // gas velocity at the particle, interval mean [m/s]
  std::array<double, 3> steady_force{};  // forces that do not depend on v [N]
  std::array<double, 3> taken{};         // drag impulse taken since the last coupling [N s]
  std::array<double, 3> expected{};      // drag impulse the gas gave at the last coupling [N s]
};

inline constexpr int exchange_record_size = 13;
static_assert(std::is_trivially_copyable_v<ExchangeRecord>);
static_assert(sizeof(ExchangeRecord) == exchange_record_size * sizeof(double));

inline Eigen::Map<const Vec3> as_vec3(const std::array<double, 3>& a) {
  return Eigen::Map<const Vec3>(a.data());
}
inline Eigen::Map<Vec3> as_vec3(std::array<double, 3>& a) {
  return Eigen::Map<Vec3>(a.data());
}

// Drag impulse that the particle took and the gas has not yet given [N s].
inline Vec3 carry(const ExchangeRecord& record) {
  return as_vec3(record.taken) - as_vec3(record.expected);
}

}  // namespace gasgrain
