// A pendular liquid bridge between two grains, or a grain and a flat wall, as all laws of this
// folder take it.
//
//   R = 2 r_i r_j / (r_i + r_j)        Derjaguin's: two equal spheres of radius R are as flat as
//   the
//                                      pair; r of equal ones, 2 r of a grain on a wall
//   theta = (theta_i + theta_j) / 2
//
// Source: Derjaguin, Kolloid-Z. 69 (1934) 155; of bridges: Willett et al., Langmuir 16 (2000) 9396,
//   for small volumes. R is written 2 r_i r_j / (r_i + r_j) so that equal grains keep their own
//   radius: with the harmonic mean's half in its place the force at contact is half of
//   2 pi R gamma cos theta. A mean of the angles, not a product: a product is 0 as soon as one
//   grain is perfectly wetted.
// Units: SI, angles in radians. The gap is the distance of the surfaces, negative in overlap.
// Assumes: no gravity in the liquid (grains below some 1 mm), smooth grains.
#pragma once

#include <cmath>

namespace gasgrain::bridge {

inline constexpr double pi = 3.14159265358979323846;

struct LiquidBridge {
  double radius;           // Derjaguin's [m]
  double contact_angle;    // mean of the two [rad], 0 (wetting) to pi/2
  double surface_tension;  // [N/m]
  double volume;           // of liquid [m3]
  bool on_wall;            // then radius is twice the grain's
  double cos_angle;        // of the contact angle: most laws need no more
};

// The mean contact angle of two surfaces with its cosine, which is worth keeping.
struct ContactAngle {
  double mean;  // [rad]
  double cosine;
};
inline ContactAngle contact_angle_of(double angle_i, double angle_j) {
  const double mean = 0.5 * (angle_i + angle_j);
  return {mean, std::cos(mean)};
}

inline LiquidBridge bridge_of_grains(double radius_i, double radius_j, const ContactAngle& angle,
                                     double surface_tension, double volume) {
  return {2.0 * (radius_i * radius_j / (radius_i + radius_j)),
          angle.mean,
          surface_tension,
          volume,
          false,
          angle.cosine};
}
inline LiquidBridge bridge_of_grains(double radius_i, double radius_j, double angle_i,
                                     double angle_j, double surface_tension, double volume) {
  return bridge_of_grains(radius_i, radius_j, contact_angle_of(angle_i, angle_j), surface_tension,
                          volume);
}

inline LiquidBridge bridge_on_wall(double radius, double angle_grain, double angle_wall,
                                   double surface_tension, double volume) {
  const ContactAngle angle = contact_angle_of(angle_grain, angle_wall);
  return {2.0 * radius, angle.mean, surface_tension, volume, true, angle.cosine};
}

// V / R^3.
inline double reduced_volume(const LiquidBridge& b) {
  return b.volume / (b.radius * b.radius * b.radius);
}

// 2 pi R gamma cos theta [N]: the force of every bridge at contact as its volume goes to 0.
inline double contact_force(const LiquidBridge& b) {
  return 2.0 * pi * b.radius * b.surface_tension * b.cos_angle;
}

// Where a law was fitted or found to agree with the Young-Laplace equation: V / R^3 and theta.
struct BridgeRange {
  double volume_min;
  double volume_max;
  double angle_max;  // [rad]
};

template <class Law>
bool within_range(const LiquidBridge& b) {
  const double v = Law::scaled_volume(b);
  return v >= Law::range.volume_min && v <= Law::range.volume_max &&
         b.contact_angle <= Law::range.angle_max;
}

}  // namespace gasgrain::bridge
