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
#pragma once

namespace gasgrain {

template <class Force>
struct SizeOf;

}  // namespace gasgrain
