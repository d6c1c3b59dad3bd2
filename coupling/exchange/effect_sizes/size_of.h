// The estimate of a force of forces/forces.h, one specialisation each, in the file of the force's
// name. A force without one does not compile (sizes.h instantiates all of the LIST).
//
// An estimate is a struct with
//   name            the word that switches the effect on, or its usual name
//   number_name     the dimensionless number that rules it, and its formula
//   threshold       in words: where it begins to matter, and who says so
//   number(Scales)  that number
//   force(Scales)   its size [N] on a grain, for its share of weight and drag (share_of_motion). Of
//                   a torque: over the radius. Of an effect that is no force: the change of the
//                   drag, or of the gas's momentum per grain (Scales::per_grain).
// and, where the law holds in a range only beyond which its size means nothing,
//   in_range(Scales)
#pragma once

#include <type_traits>
#include <utility>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

template <class Force>
struct SizeOf;

template <class Size, class = void>
struct HasRange : std::false_type {};
template <class Size>
struct HasRange<Size, std::void_t<decltype(Size::in_range(std::declval<Scales>()))>>
    : std::true_type {};

// Whether an effect of this size [N] is needed at these scales.
template <class Size>
bool is_needed(const Scales& at, double force) {
  if constexpr (HasRange<Size>::value)
    if (!Size::in_range(at)) return false;
  return force > 0.0 && share_of_motion(at, force) >= needed_share;
}

}  // namespace gasgrain
