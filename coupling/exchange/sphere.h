// Geometry of a sphere.
#pragma once

namespace gasgrain {

inline constexpr double pi = 3.14159265358979323846;

inline double sphere_volume(double radius) {
  return 4.0 / 3.0 * pi * radius * radius * radius;
}

inline double sphere_surface(double radius) {
  return 4.0 * pi * radius * radius;
}

}  // namespace gasgrain
