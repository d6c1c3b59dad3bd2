// Size of what turns grains: friction in contacts.
//
//   F = mu_f m g,   number: mu_f, the greatest tangential force over the normal one (Coulomb)
//
// of a contact that carries the grain's weight. Without rotation grains slide on each other instead
// of rolling. Source: Coulomb's law. Inputs: mu_f, weight.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeRotation {
  static constexpr std::string_view name = "rotation";
  static constexpr std::string_view number_name = "coefficient of friction";
  static constexpr std::string_view threshold =
      "0.05; thesis 5.3: very important, as Magnus' force depends on it";

  static double number(const Scales& at) { return at.friction; }
  static double force(const Scales& at) { return at.friction * at.weight(); }
};

}  // namespace gasgrain
