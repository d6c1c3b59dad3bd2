#include "tools/measure/slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

constexpr double degree = 180.0 / M_PI;

struct Bin {
  double height = 0.0;  // sum, then mean
  int count = 0;
};

std::vector<Bin> mean_profile(const std::vector<SurfacePoint>& points, double width) {
  std::vector<Bin> bins;
  for (const auto& point : points) {
    const auto n = static_cast<std::size_t>(std::max(0.0, point.s / width));
    if (n >= bins.size()) bins.resize(n + 1);
    bins[n].height += point.position.z();
    ++bins[n].count;
  }
  for (auto& bin : bins)
    if (bin.count > 0) bin.height /= bin.count;
  return bins;
}

}  // namespace

std::vector<Grain> grains_above(double floor, const DumpFrame& frame,
                                const std::filesystem::path& dump, const std::string& too_few) {
  auto grains = frame.grains();
  const auto above = [&](const Grain& grain) { return grain.position.z() > floor; };
  grains.erase(std::partition(grains.begin(), grains.end(), above), grains.end());
  constexpr std::size_t fewest = 50;
  if (grains.size() < fewest)
    fail("{}: {} grains lie above z = {:g} m in the last frame, at least {} are needed: {}",
         dump.string(), grains.size(), floor, fewest, too_few);
  return grains;
}

Extent extent_of(const std::vector<Grain>& grains) {
  constexpr double far = std::numeric_limits<double>::max();
  Extent extent{{far, -far, far, -far}, 0.0};
  for (const auto& [centre, radius] : grains) {
    extent.box.x_lo = std::min(extent.box.x_lo, centre.x() - radius);
    extent.box.x_hi = std::max(extent.box.x_hi, centre.x() + radius);
    extent.box.y_lo = std::min(extent.box.y_lo, centre.y() - radius);
    extent.box.y_hi = std::max(extent.box.y_hi, centre.y() + radius);
    extent.diameter += 2.0 * radius / static_cast<double>(grains.size());
  }
  return extent;
}

std::vector<SurfacePoint> seen_from_above(const std::vector<Grain>& grains, const Box2& box,
                                          double pitch, double floor) {
  const int nx = std::max(1, static_cast<int>(std::lround((box.x_hi - box.x_lo) / pitch)));
  const int ny = std::max(1, static_cast<int>(std::lround((box.y_hi - box.y_lo) / pitch)));
  const double dx = (box.x_hi - box.x_lo) / nx;
  const double dy = (box.y_hi - box.y_lo) / ny;
  std::vector<SurfacePoint> points(static_cast<std::size_t>(nx) * ny);
  const auto point = [&](int i, int j) -> Vec3& {
    return points[static_cast<std::size_t>(j) * nx + i].position;
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      point(i, j) = Vec3(box.x_lo + (i + 0.5) * dx, box.y_lo + (j + 0.5) * dy, floor);
  for (const auto& [centre, radius] : grains) {
    const auto first = [](double from, double lo, double step) {
      return std::max(0, static_cast<int>(std::ceil((from - lo) / step - 0.5)));
    };
    const auto last = [](double to, double lo, double step, int count) {
      return std::min(count - 1, static_cast<int>(std::floor((to - lo) / step - 0.5)));
    };
    for (int j = first(centre.y() - radius, box.y_lo, dy);
         j <= last(centre.y() + radius, box.y_lo, dy, ny); ++j)
      for (int i = first(centre.x() - radius, box.x_lo, dx);
           i <= last(centre.x() + radius, box.x_lo, dx, nx); ++i) {
        Vec3& seen = point(i, j);
        const double off = (seen - centre).head<2>().squaredNorm();
        if (off <= radius * radius)
          seen.z() = std::max(seen.z(), centre.z() + std::sqrt(radius * radius - off));
      }
  }
  return points;
}

double Line::angle_degree() const {
  return std::atan(-slope) * degree;
}

Line fitted_line(const std::vector<SurfacePoint>& points) {
  double s = 0.0;
  double h = 0.0;
  for (const auto& point : points) {
    s += point.s;
    h += point.position.z();
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, points.size()));
  s /= count;
  h /= count;
  double ss = 0.0;
  double sh = 0.0;
  for (const auto& point : points) {
    ss += (point.s - s) * (point.s - s);
    sh += (point.s - s) * (point.position.z() - h);
  }
  if (ss <= 0.0) fail("there are no two distances to lay a line through.");
  const double slope = sh / ss;
  return {h - slope * s, slope};
}

Flank fitted_flank(const std::vector<SurfacePoint>& points, const FlankRange& range) {
  const auto bins = mean_profile(points, range.bin);
  double greatest = 0.0;
  for (const auto& bin : bins) greatest = std::max(greatest, bin.height - range.floor);
  // Down from the highest bin: the flank ends where the profile first falls below its lower end.
  std::size_t first = 0;
  while (first < bins.size() && bins[first].height - range.floor < greatest) ++first;
  while (first < bins.size() && bins[first].height - range.floor > range.high * greatest) ++first;
  std::size_t last = first;
  while (last < bins.size() && bins[last].height - range.floor >= range.low * greatest) ++last;
  constexpr std::size_t least_bins = 3;
  if (last < first + least_bins)
    fail(
        "the flank is {} bins of {:.3g} m wide, from {:g} to {:g} of the greatest height, {:.3g} "
        "m; "
        "at least {} are needed: take more grains.",
        last - first, range.bin, range.low, range.high, greatest, least_bins);

  Flank flank;
  flank.from = static_cast<double>(first) * range.bin;
  flank.to = static_cast<double>(last) * range.bin;
  std::vector<SurfacePoint> inside;
  for (const auto& point : points)
    if (point.s >= flank.from && point.s < flank.to) inside.push_back(point);
  flank.line = fitted_line(inside);
  flank.angle_degree = flank.line.angle_degree();

  double sum = 0.0;
  double squares = 0.0;
  for (int part = 0; part < range.parts; ++part) {
    std::vector<SurfacePoint> own;
    for (const auto& point : inside)
      if (point.part == part) own.push_back(point);
    const double angle = fitted_line(own).angle_degree();
    sum += angle;
    squares += angle * angle;
  }
  const int parts = range.parts;
  if (parts > 1)
    flank.uncertainty_degree =
        std::sqrt(std::max(0.0, squares - sum * sum / parts) / (parts - 1) / parts);

  flank.profile.columns = {"distance_m", "height_m", "line_m"};
  for (std::size_t n = 0; n < bins.size(); ++n) {
    const double s = (static_cast<double>(n) + 0.5) * range.bin;
    const bool is_flank = n >= first && n < last;
    flank.profile.rows.push_back(
        {s, bins[n].height,
         is_flank ? flank.line.at(s) : std::numeric_limits<double>::quiet_NaN()});
  }
  return flank;
}

}  // namespace gasgrain
