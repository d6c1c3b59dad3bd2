// Size of the force of electric and magnetic fields.
//
//   F = q (E + v B);   number: F / (m g)
//
// Source: the force itself. Inputs: charge, fields, speed: those of the scene; a scene without them
// has none. v and B are taken as perpendicular: the greatest.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effect_sizes/size_of.h"
#include "coupling/exchange/forces/lorentz.h"

namespace gasgrain {

template <>
struct SizeOf<ForceLorentz> {
  static constexpr std::string_view name = ForceLorentz::name;
  static constexpr std::string_view number_name = "q (E + v B) / (m g)";
  static constexpr std::string_view threshold =
      "0.05, for fields that the scene names; thesis: in the balance, not used";

  static double number(const Scales& at) { return ratio(force(at), at.weight()); }
  static double force(const Scales& at) {
    return at.charge * (at.electric + at.speed * at.magnetic);
  }
};

}  // namespace gasgrain
