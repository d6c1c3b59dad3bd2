// Dynamic angle of repose: the inclination of the surface in a drum that turns about the y axis.
//
// In each frame what is seen from above is fitted over x in the middle of the surface, the share
// `chord` of its width. The angle counts as positive whichever way the drum turns. The uncertainty
// is the standard error over `blocks` parts of the time: frames that follow each other are alike.
#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/kinds.h"
#include "tools/measure/series.h"
#include "tools/measure/slope.h"

namespace gasgrain {

namespace {

struct DrumKeys {
  std::string dump;
  double chord = 0.0;
  int blocks = 0;
};

// Of one frame; the points of the surface without those where no grain is seen.
double surface_angle(const std::vector<Grain>& grains, double chord) {
  const Extent extent = extent_of(grains);
  const double middle = 0.5 * (extent.box.x_lo + extent.box.x_hi);
  const double half = 0.5 * chord * (extent.box.x_hi - extent.box.x_lo);
  const double none = -std::numeric_limits<double>::max();
  auto points = seen_from_above(grains, extent.box, extent.diameter / points_per_grain, none);
  for (auto& point : points) point.s = point.position.x();
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const SurfacePoint& point) {
                                return std::abs(point.s - middle) > half ||
                                       point.position.z() == none;
                              }),
               points.end());
  return std::abs(fitted_line(points).angle_degree());
}

Measurement measure_drum(const std::filesystem::path& results, const DrumKeys& keys) {
  const auto file = results / keys.dump;
  const auto frames = read_dump(file);
  if (frames.size() < static_cast<std::size_t>(2 * keys.blocks))
    fail("{}: {} frames are too few for {} blocks of time: at least {} are needed.", file.string(),
         frames.size(), keys.blocks, 2 * keys.blocks);
  Measurement measured;
  measured.curve.columns = {"step", "angle_degree"};
  std::vector<double> angles;
  constexpr std::size_t fewest = 50;
  for (const auto& frame : frames) {
    if (frame.size() < fewest)
      fail("{}: {} grains in step {}: at least {} are needed.", file.string(), frame.size(),
           frame.step(), fewest);
    angles.push_back(surface_angle(frame.grains(), keys.chord));
    measured.curve.rows.push_back({static_cast<double>(frame.step()), angles.back()});
  }
  const BlockMean mean = block_mean(angles, keys.blocks);
  measured.quantities = {{"dynamic_angle", mean.value, "degree", mean.uncertainty}};
  return measured;
}

}  // namespace

Measure read_drum(InputTable& table) {
  DrumKeys keys;
  keys.dump = table.text("dump", "particles/drum.dump");
  keys.chord = table.number("chord", 0.6, Range::within(0.1, 1.0), "1");
  keys.blocks = table.integer("blocks", 5, Range::within(2, 100));
  return [keys](const std::filesystem::path& results) { return measure_drum(results, keys); };
}

}  // namespace gasgrain
