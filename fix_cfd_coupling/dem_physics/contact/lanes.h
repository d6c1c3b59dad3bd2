// One number of each of several contacts in one vector register, to be used where a law says Real.
//
// Isa names the instruction set that a file is compiled for, so that code for different ones never
// has the same name: the linker would keep one of them for all machines. Whatever is not a template
// of Isa must be inlined in those files (a test looks at their symbols).
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/batch_loop.h"

namespace gasgrain::contact {

// Four doubles side by side: a vector in space and one number more.
using Quad [[gnu::vector_size(32), gnu::may_alias]] = double;

template <int lanes>
struct RegisterOf {
  using Numbers [[gnu::vector_size(8 * lanes)]] = double;
  using Choices [[gnu::vector_size(8 * lanes)]] = long long;
};

template <class Isa>
struct Choice {
  using Register = typename RegisterOf<Isa::lanes>::Choices;
  Register yes;
};
template <class Isa>
[[gnu::always_inline]] inline Choice<Isa> operator!(const Choice<Isa>& a) {
  return {~a.yes};
}
template <class Isa>
[[gnu::always_inline]] inline Choice<Isa> operator&(const Choice<Isa>& a, const Choice<Isa>& b) {
  return {a.yes & b.yes};
}
// Among several contacts there is some of every case, mostly.
template <class Isa>
[[gnu::always_inline]] inline constexpr bool any(const Choice<Isa>&) {
  return true;
}

template <class Isa>
struct Lanes {
  using Register = typename RegisterOf<Isa::lanes>::Numbers;
  Register of;

  Lanes() = default;
  [[gnu::always_inline]] inline Lanes(const Register& values) : of(values) {}
  [[gnu::always_inline]] inline Lanes(double value) : of(value - Register{}) {}

  [[gnu::always_inline]] friend inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return a.of + b.of;
  }
  [[gnu::always_inline]] friend inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return a.of - b.of;
  }
  [[gnu::always_inline]] friend inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return a.of * b.of;
  }
  [[gnu::always_inline]] friend inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return a.of / b.of;
  }
  [[gnu::always_inline]] friend inline Lanes operator-(const Lanes& a) { return -a.of; }
  [[gnu::always_inline]] friend inline Choice<Isa> operator>(const Lanes& a, const Lanes& b) {
    return {a.of > b.of};
  }
  [[gnu::always_inline]] friend inline Choice<Isa> operator<(const Lanes& a, const Lanes& b) {
    return {a.of < b.of};
  }
  [[gnu::always_inline]] friend inline Choice<Isa> operator==(const Lanes& a, const Lanes& b) {
    return {a.of == b.of};
  }
  [[gnu::always_inline]] friend inline Lanes select(const Choice<Isa>& choice, const Lanes& then,
                                                    const Lanes& otherwise) {
    return choice.yes ? then.of : otherwise.of;
  }
  [[gnu::always_inline]] friend inline Lanes abs(const Lanes& a) { return select(a < 0.0, -a, a); }
  [[gnu::always_inline]] friend inline Lanes sqrt(const Lanes& a) {
    Register root;
    for (int lane = 0; lane < Isa::lanes; ++lane) root[lane] = __builtin_sqrt(a.of[lane]);
    return root;
  }
};

using TwoSideBySide [[gnu::vector_size(16), gnu::may_alias]] = double;
struct [[gnu::packed]] Two {
  TwoSideBySide of;
};

// The host has three doubles of a grain side by side, aligned for one.
[[gnu::always_inline]] inline Quad quad_of(const double* vector, double last) {
  const TwoSideBySide two = reinterpret_cast<const Two*>(vector)->of;
  return Quad{two[0], two[1], vector[2], last};
}
[[gnu::always_inline]] inline void add_to(double* vector, const Quad& what) {
  Two& two = *reinterpret_cast<Two*>(vector);
  two.of = two.of + TwoSideBySide{what[0], what[1]};
  vector[2] += what[2];
}

// Four quads to one register for each of their places, and back.
[[gnu::always_inline]] inline void turn(const Quad from[4], Quad to[4]) {
  const Quad a = __builtin_shufflevector(from[0], from[1], 0, 4, 2, 6);
  const Quad b = __builtin_shufflevector(from[0], from[1], 1, 5, 3, 7);
  const Quad c = __builtin_shufflevector(from[2], from[3], 0, 4, 2, 6);
  const Quad d = __builtin_shufflevector(from[2], from[3], 1, 5, 3, 7);
  to[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  to[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  to[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  to[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

[[gnu::always_inline]] inline void columns_of(const Quad (&quads)[4], Lanes<Avx2> (&columns)[4]) {
  Quad turned[4];
  turn(quads, turned);
  for (int n = 0; n < 4; ++n) columns[n] = turned[n];
}
[[gnu::always_inline]] inline void columns_of(const Quad (&quads)[8], Lanes<Avx512> (&columns)[4]) {
  Quad low[4], high[4];
  turn(quads, low);
  turn(quads + 4, high);
  for (int n = 0; n < 4; ++n)
    columns[n] = __builtin_shufflevector(low[n], high[n], 0, 1, 2, 3, 4, 5, 6, 7);
}
[[gnu::always_inline]] inline void quads_of(const Lanes<Avx2> (&columns)[4], Quad (&quads)[4]) {
  const Quad from[4] = {columns[0].of, columns[1].of, columns[2].of, columns[3].of};
  turn(from, quads);
}
[[gnu::always_inline]] inline void quads_of(const Lanes<Avx512> (&columns)[4], Quad (&quads)[8]) {
  Quad low[4], high[4];
  for (int n = 0; n < 4; ++n) {
    low[n] = __builtin_shufflevector(columns[n].of, columns[n].of, 0, 1, 2, 3);
    high[n] = __builtin_shufflevector(columns[n].of, columns[n].of, 4, 5, 6, 7);
  }
  turn(low, quads);
  turn(high, quads + 4);
}

}  // namespace gasgrain::contact
