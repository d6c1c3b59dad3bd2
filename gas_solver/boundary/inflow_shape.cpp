#include "gas_solver/boundary/inflow_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gasgrain {
namespace {

constexpr double pi = 3.14159265358979323846;

Rectangle common(const Rectangle& a, const Rectangle& b) {
  Rectangle c;
  for (int d = 0; d < 2; ++d) {
    c.lo[d] = std::max(a.lo[d], b.lo[d]);
    c.hi[d] = std::max(c.lo[d], std::min(a.hi[d], b.hi[d]));
  }
  return c;
}

// Integral of sqrt(r^2 - x^2) from 0 to x, |x| <= r.
double integral_of_circle(double x, double r) {
  const double s = std::clamp(x / r, -1.0, 1.0);
  return 0.5 * r * r * (s * std::sqrt(1 - s * s) + std::asin(s));
}

// Area of the circle of radius r around the origin within a rectangle. The strip between two
// abscissae where the circle crosses no edge of the rectangle is bounded above by either the edge
// or the circle, and so below: each such strip is integrated in closed form.
double circle_in_rectangle(double r, const Rectangle& box) {
  const double x0 = std::max(box.lo[0], -r);
  const double x1 = std::min(box.hi[0], r);
  if (x1 <= x0) return 0;
  std::vector<double> cuts{x0, x1};
  for (const double y : {box.lo[1], box.hi[1]})
    if (std::abs(y) < r)
      for (const double x : {-std::sqrt(r * r - y * y), std::sqrt(r * r - y * y)})
        if (x > x0 && x < x1) cuts.push_back(x);
  std::sort(cuts.begin(), cuts.end());
  double area = 0;
  for (std::size_t n = 0; n + 1 < cuts.size(); ++n) {
    const double a = cuts[n];
    const double b = cuts[n + 1];
    const double middle = 0.5 * (a + b);
    const double height = std::sqrt(std::max(0.0, r * r - middle * middle));
    if (std::min(height, box.hi[1]) <= std::max(-height, box.lo[1])) continue;
    const double arc = integral_of_circle(b, r) - integral_of_circle(a, r);
    const double top = height <= box.hi[1] ? arc : box.hi[1] * (b - a);
    const double bottom = -height >= box.lo[1] ? -arc : box.lo[1] * (b - a);
    area += top - bottom;
  }
  return area;
}

std::array<double, 2> center(const Rectangle& r) {
  return {0.5 * (r.lo[0] + r.hi[0]), 0.5 * (r.lo[1] + r.hi[1])};
}

double radius(const Outline& circle) {
  return 0.5 * (circle.bounds.hi[0] - circle.bounds.lo[0]);
}

}  // namespace

double Rectangle::area() const {
  return (hi[0] - lo[0]) * (hi[1] - lo[1]);
}

double Outline::area() const {
  return round ? pi * radius(*this) * radius(*this) : bounds.area();
}

double common_area(const Outline& outline, const Rectangle& rectangle) {
  if (!outline.round) return common(outline.bounds, rectangle).area();
  const auto c = center(outline.bounds);
  Rectangle around_origin = rectangle;
  for (int d = 0; d < 2; ++d) {
    around_origin.lo[d] -= c[d];
    around_origin.hi[d] -= c[d];
  }
  return circle_in_rectangle(radius(outline), around_origin);
}

bool overlap(const Outline& a, const Outline& b) {
  // Patches may touch: areas below this share of the smaller one are round-off.
  constexpr double round_off = 1e-9;
  const double least = round_off * std::min(a.area(), b.area());
  if (!b.round) return common_area(a, b.bounds) > least;
  if (!a.round) return common_area(b, a.bounds) > least;
  const auto ca = center(a.bounds);
  const auto cb = center(b.bounds);
  return std::hypot(ca[0] - cb[0], ca[1] - cb[1]) < (radius(a) + radius(b)) * (1 - round_off);
}

}  // namespace gasgrain
