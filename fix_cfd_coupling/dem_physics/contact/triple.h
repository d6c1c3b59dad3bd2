// A vector of three as the loops over contacts use it: all of it in registers. (Vec3 is general,
// and compilers keep it in memory where many functions are inlined into one loop.) Real is a
// double, or one of each of several contacts (lanes.h).
#pragma once

#include <cmath>
#include <type_traits>

#include "coupling/base/vec3.h"

namespace gasgrain::contact {

template <class Real>
struct TripleOf {
  Real x = 0.0, y = 0.0, z = 0.0;

  static TripleOf of(const Real* v) { return {v[0], v[1], v[2]}; }
  static TripleOf of(const Vec3& v) { return {v[0], v[1], v[2]}; }
  [[nodiscard]] Vec3 vec3() const { return {x, y, z}; }
  Real* data() { return &x; }
  [[nodiscard]] const Real* data() const { return &x; }

  [[nodiscard]] [[gnu::always_inline]] inline Real dot(const TripleOf& o) const {
    return x * o.x + y * o.y + z * o.z;
  }
  [[nodiscard]] [[gnu::always_inline]] inline Real norm() const {
    using std::sqrt;
    return sqrt(dot(*this));
  }
  [[nodiscard]] [[gnu::always_inline]] inline auto is_zero() const {
    return (x == 0.0) & (y == 0.0) & (z == 0.0);
  }
  [[gnu::always_inline]] inline void add_to(Real* v) const {
    v[0] += x;
    v[1] += y;
    v[2] += z;
  }
  [[gnu::always_inline]] inline void store(Real* v) const {
    v[0] = x;
    v[1] = y;
    v[2] = z;
  }
  [[gnu::always_inline]] inline TripleOf& operator+=(const TripleOf& o) {
    return *this = {x + o.x, y + o.y, z + o.z};
  }
  [[gnu::always_inline]] inline TripleOf& operator-=(const TripleOf& o) {
    return *this = {x - o.x, y - o.y, z - o.z};
  }
  [[gnu::always_inline]] inline TripleOf& operator*=(const Real& f) {
    return *this = {f * x, f * y, f * z};
  }
};
using Triple = TripleOf<double>;
static_assert(sizeof(Triple) == 3 * sizeof(double));

template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> operator+(const TripleOf<Real>& a,
                                                       const TripleOf<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> operator-(const TripleOf<Real>& a,
                                                       const TripleOf<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> operator-(const TripleOf<Real>& a) {
  return {-a.x, -a.y, -a.z};
}
// The factor may be a plain number.
template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> operator*(const std::common_type_t<Real>& f,
                                                       const TripleOf<Real>& a) {
  return {f * a.x, f * a.y, f * a.z};
}
template <class Real>
[[gnu::always_inline]] inline TripleOf<Real> cross(const TripleOf<Real>& a,
                                                   const TripleOf<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Choices as laws write them, for one contact and for several: any() where a case may be left out
// when no contact is in it, select() in it.
inline bool any(bool yes) {
  return yes;
}
inline double select(bool yes, double then, double otherwise) {
  return yes ? then : otherwise;
}
template <class Mask, class Real>
[[gnu::always_inline]] inline TripleOf<Real> select(const Mask& yes, const TripleOf<Real>& then,
                                                    const TripleOf<Real>& otherwise) {
  return {select(yes, then.x, otherwise.x), select(yes, then.y, otherwise.y),
          select(yes, then.z, otherwise.z)};
}

}  // namespace gasgrain::contact
