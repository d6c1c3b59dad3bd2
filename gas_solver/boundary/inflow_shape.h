// The outlines an inflow patch may have, in the plane of its side: areas and overlaps, exact.
#pragma once

#include <array>
#include <string_view>

namespace gasgrain {

// An axis-parallel rectangle a0 <= a <= a1, b0 <= b <= b1 of the plane [m].
struct Rectangle {
  std::array<double, 2> lo{0, 0};
  std::array<double, 2> hi{0, 0};
  [[nodiscard]] double area() const;
};

enum class InflowShape { rectangle, circle, whole };
inline constexpr std::array<std::string_view, 3> inflow_shape_names{"rectangle", "circle", "whole"};

// A rectangle (also what "whole" becomes) or the circle inscribed in its bounds.
struct Outline {
  Rectangle bounds;
  bool round = false;
  [[nodiscard]] double area() const;
};

// Area that an outline has in common with a rectangle [m2].
double common_area(const Outline& outline, const Rectangle& rectangle);
bool overlap(const Outline& a, const Outline& b);

}  // namespace gasgrain
