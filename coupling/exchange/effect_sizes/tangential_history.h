// Size of friction at rest, which needs the memory of the tangential spring.
//
//   F = mu_f m g / (1 + I / 0.3),   number: I = (v / H) d / (p / rho_p)^(1/2),  p = phi rho_p g H
//
// I is the inertial number of a bed of height H that is sheared by its own speed: below 0.3
// contacts last and static friction counts, beyond it grains only collide. Source: GDR MiDi, Eur.
// Phys. J. E 14 (2004) 341. Inputs: mu_f, v (speed_scatter), d, H, eps, g.
#pragma once

#include <cmath>
#include <string_view>

#include "coupling/exchange/effect_sizes/scales.h"

namespace gasgrain {

struct SizeTangentialHistory {
  static constexpr std::string_view name = "tangential history";
  static constexpr std::string_view number_name = "I = (v / H) d / (phi g H)^(1/2)";
  static constexpr std::string_view threshold =
      "I below 0.3: grains stay in touch (GDR MiDi 2004); thesis 5.1: spring, damper and slider";

  static constexpr double collisional = 0.3;

  static double number(const Scales& at) {
    if (at.speed_scatter == 0.0 || at.bed_height == 0.0) return 0.0;
    return ratio(at.speed_scatter / at.bed_height * at.diameter,
                 std::sqrt(at.solids() * at.gravity * at.bed_height));
  }
  static double force(const Scales& at) {
    return at.friction * at.weight() / (1.0 + number(at) / collisional);
  }
};

}  // namespace gasgrain
