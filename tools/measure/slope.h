// The angle of a surface of grains: a straight line through what is seen of them from above.
//
// At the points of a fine horizontal grid the highest surface of a grain (the floor where there is
// none) is a height h over a distance s. What is seen lies a part of a diameter below the outermost
// tops, by as much all along a slope, so that the angle
//   alpha = atan(-dh/ds)
// of the least-squares line is not changed by it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/measure/dump_file.h"
#include "tools/measure/measurement.h"

namespace gasgrain {

struct SurfacePoint {
  Vec3 position = Vec3::Zero();  // z: of the surface that is seen
  double s = 0.0;                // distance down the slope [m]
  int part = 0;                  // sector or strip, for the uncertainty
};

struct Box2 {
  double x_lo, x_hi, y_lo, y_hi;
};

// Of the last frame of a dump, the grains above a height [m]. Throws Error, with what it means,
// when they are fewer than a surface needs.
std::vector<Grain> grains_above(double floor, const DumpFrame& frame,
                                const std::filesystem::path& dump, const std::string& too_few);

// Where grains lie, surfaces included, and their mean diameter.
struct Extent {
  Box2 box;
  double diameter;
};
Extent extent_of(const std::vector<Grain>& grains);

constexpr double points_per_grain = 4.0;  // across: a fine enough grid

// The points of a grid over the box, about `pitch` apart.
std::vector<SurfacePoint> seen_from_above(const std::vector<Grain>& grains, const Box2& box,
                                          double pitch, double floor);

struct Line {
  double height = 0.0;  // at s = 0
  double slope = 0.0;   // dh/ds
  [[nodiscard]] double angle_degree() const;
  [[nodiscard]] double at(double s) const { return height + slope * s; }
};

// Least squares; throws Error when all points have one s.
Line fitted_line(const std::vector<SurfacePoint>& points);

struct Flank {
  Line line;
  double from = 0.0;  // range of s that was fitted [m]
  double to = 0.0;
  double angle_degree = 0.0;
  double uncertainty_degree = 0.0;  // standard error over the parts
  Curve profile;                    // distance_m, height_m, line_m
};

struct FlankRange {
  double low = 0.1;   // the flank: from this share of the greatest height ...
  double high = 0.9;  // ... to this one
  double bin = 0.0;   // width of a bin of s [m]
  double floor = 0.0;
  int parts = 8;
};

// The flank of a slope that descends with s. Throws Error when the flank has less than 3 bins.
Flank fitted_flank(const std::vector<SurfacePoint>& points, const FlankRange& range);

}  // namespace gasgrain
