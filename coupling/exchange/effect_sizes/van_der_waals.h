// Size of van der Waals' force between two rough grains.
//
//   F = A r / (6 z^2),   number: the granular Bond number Bo = F / (m g)
//
// of an asperity of r = 0.1 um on a grain at z = 0.4 nm, A = 6.5e-20 J (glass in air).
// Source: L. Massimilla, G. Donsi, Powder Technol. 15 (1976) 253; H.C. Hamaker (1937). Input:
// weight.
#pragma once

#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeVanDerWaals {
  static constexpr std::string_view name = "van der Waals";
  static constexpr std::string_view number_name = "Bo = A r / (6 z^2 m g)";
  static constexpr std::string_view threshold =
      "Bo of 0.05, below some 0.2 mm (Massimilla, Donsi 1976); thesis 5.3: for micro-size grains";

  static double number(const Scales& at) { return ratio(force(at), at.weight()); }
  static double force(const Scales& at) {
    constexpr double hamaker = 6.5e-20;  // A [J]
    constexpr double asperity = 1e-7;    // r [m]
    constexpr double distance = 4e-10;   // z [m]
    return at.diameter > 0.0 ? hamaker * asperity / (6.0 * distance * distance) : 0.0;
  }
};

}  // namespace gasgrain
