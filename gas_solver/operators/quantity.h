// A property of the gas that is one number, or a field over the cells when an effect of the scene
// makes it one. Loops are compiled for either, so that a number costs no memory access.
#pragma once

#include <cstddef>
#include <variant>

#include "coupling/base/array3.h"
#include "coupling/base/listed.h"

namespace gasgrain {

struct ConstantQuantity {
  double value;
  double operator()(std::ptrdiff_t) const { return value; }
};

struct FieldQuantity {
  const double* values;
  double operator()(std::ptrdiff_t o) const { return values[o]; }
};

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_QUANTITIES
#define GASGRAIN_QUANTITIES ConstantQuantity, FieldQuantity
#endif
using Quantity = std::variant<GASGRAIN_QUANTITIES>;

inline Quantity quantity(const Array3<double>& field, double constant) {
  if (field.size() == 0) return ConstantQuantity{constant};
  return listed<Quantity>([&] { return FieldQuantity{field.data()}; });
}

// At the face between the cell at `o` and the one before it, `s` offsets away.
template <class Q>
double face_value(const Q& of, std::ptrdiff_t o, std::ptrdiff_t s) {
  return 0.5 * (of(o - s) + of(o));
}

}  // namespace gasgrain
