// A vector of three as the loops over contacts use it: all of it in registers. (Vec3 is general,
// and compilers keep it in memory where many functions are inlined into one loop.)
#pragma once

#include <cmath>

#include "coupling/base/vec3.h"

namespace gasgrain::contact {

struct Triple {
  double x = 0.0, y = 0.0, z = 0.0;

  static Triple of(const double* v) { return {v[0], v[1], v[2]}; }
  static Triple of(const Vec3& v) { return {v[0], v[1], v[2]}; }
  [[nodiscard]] Vec3 vec3() const { return {x, y, z}; }
  double* data() { return &x; }
  [[nodiscard]] const double* data() const { return &x; }

  [[nodiscard]] double dot(const Triple& o) const { return x * o.x + y * o.y + z * o.z; }
  [[nodiscard]] double norm() const { return std::sqrt(dot(*this)); }
  [[nodiscard]] bool is_zero() const { return x == 0.0 && y == 0.0 && z == 0.0; }
  void add_to(double* v) const {
    v[0] += x;
    v[1] += y;
    v[2] += z;
  }
  void store(double* v) const {
    v[0] = x;
    v[1] = y;
    v[2] = z;
  }
  Triple& operator+=(const Triple& o) { return *this = {x + o.x, y + o.y, z + o.z}; }
  Triple& operator-=(const Triple& o) { return *this = {x - o.x, y - o.y, z - o.z}; }
  Triple& operator*=(double f) { return *this = {f * x, f * y, f * z}; }
};
static_assert(sizeof(Triple) == 3 * sizeof(double));

inline Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Triple operator-(const Triple& a) {
  return {-a.x, -a.y, -a.z};
}
inline Triple operator*(double f, const Triple& a) {
  return {f * a.x, f * a.y, f * a.z};
}
inline Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace gasgrain::contact
