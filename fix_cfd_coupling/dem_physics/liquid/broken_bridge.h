// What a division of a broken bridge's liquid knows, and what it returns.
#pragma once

namespace gasgrain::liquid {

struct Partner {
  double radius;         // [m]; infinite: a flat wall
  double contact_angle;  // [rad], 0 to pi/2
  double given;          // liquid it put into the bridge [m3]
};

struct BrokenBridge {
  double volume;  // of liquid at rupture [m3]
  Partner i, j;
};

// Liquid that goes back [m3].
struct Division {
  double to_i;
  double to_j;
};

// One side has its share, the other what is left: nothing is lost to round-off.
inline Division divide_by_share(double volume, double share_i) {
  const double to_i = volume * share_i;
  return {to_i, volume - to_i};
}

}  // namespace gasgrain::liquid
