// How much of the voids between grains is filled with the liquid of bridges.
//
//   S = V_bridges / V_voids,   V_voids = V_grains eps / (1 - eps)
//
// Source: Alobaid (2013), eq. 5.75; Schubert (1979): below 0.2 bridges are apart from each other
//   (pendular), from there they merge (funicular), and laws of single bridges no longer hold.
// Inputs: liquid and solid volume [m3]; eps, void fraction of the packing.
#pragma once

namespace gasgrain::liquid {

inline constexpr double pendular_up_to = 0.2;

inline double saturation(double liquid, double solid, double void_fraction) {
  return solid > 0.0 ? liquid * (1.0 - void_fraction) / (solid * void_fraction) : 0.0;
}

}  // namespace gasgrain::liquid
