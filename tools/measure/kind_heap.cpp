// Angle of repose of a heap on a plate: the slope of its flank, all around.
//
// The heap's axis is the mean position of its grains. What is seen from above is fitted over
// the distance from the axis where the mean profile lies between two shares of its greatest
// height: the round top and the loose foot do not count. The uncertainty is the standard error of
// the sectors' own angles.
#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/at_rest.h"
#include "tools/measure/kinds.h"
#include "tools/measure/slope.h"

namespace gasgrain {

namespace {

struct HeapKeys {
  std::string dump;
  double low = 0.0;
  double high = 0.0;
  double floor = 0.0;
  int sectors = 0;
};

Measurement measure_heap(const std::filesystem::path& results, const HeapKeys& keys) {
  const auto file = results / keys.dump;
  const DumpFrame frame = read_dump(file).back();
  const auto grains = grains_above(keys.floor, frame, file, "that is no heap.");

  Vec3 axis = Vec3::Zero();
  double diameter = 0.0;
  for (const auto& grain : grains) {
    axis += grain.position;
    diameter += 2.0 * grain.radius;
  }
  const auto count = static_cast<double>(grains.size());
  axis /= count;
  diameter /= count;
  double reach = 0.0;
  for (const auto& grain : grains)
    reach = std::max(reach, (grain.position - axis).head<2>().norm());
  reach += diameter;

  auto points = seen_from_above(
      grains, {axis.x() - reach, axis.x() + reach, axis.y() - reach, axis.y() + reach},
      diameter / points_per_grain, keys.floor);
  for (auto& point : points) {
    const Vec3 from_axis = point.position - axis;
    point.s = from_axis.head<2>().norm();
    const double turn = (std::atan2(from_axis.y(), from_axis.x()) + M_PI) / (2.0 * M_PI);
    point.part = std::min(keys.sectors - 1, static_cast<int>(turn * keys.sectors));
  }
  // Rings that the square cuts off are no rings.
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const SurfacePoint& point) { return point.s > reach; }),
               points.end());
  const Flank flank =
      fitted_flank(points, {keys.low, keys.high, diameter, keys.floor, keys.sectors});
  constexpr double lowest = 2.5;  // diameters: below, layers of grains are no slope
  const double height = flank.profile.rows.front()[1] - keys.floor;
  if (height < lowest * diameter)
    fail(
        "{}: the grains lie {:.2g} m high, {:.2g} diameters: that is no heap. Take more grains, or "
        "more friction.",
        file.string(), height, height / diameter);
  Measurement measured;
  measured.quantities = {
      {"angle_of_repose", flank.angle_degree, "degree", flank.uncertainty_degree},
      {"heap_height", height, "m", 0.0}};
  measured.curve = flank.profile;
  if (const auto note = motion_note(frame, keys.floor); !note.empty())
    measured.notes.push_back(note);
  return measured;
}

}  // namespace

Measure read_heap(InputTable& table) {
  HeapKeys keys;
  keys.dump = table.text("dump", "particles/heap.dump");
  keys.low = table.number("flank_from", 0.1, Range::within(0.0, 1.0), "1");
  keys.high = table.number("flank_to", 0.9, Range::within(0.0, 1.0), "1");
  keys.floor = table.number("floor", 0.0, Range::any(), "m");
  keys.sectors = table.integer("sectors", 8, Range::within(2, 36));
  if (keys.low >= keys.high)
    table.fault("flank_from", fmt::format("flank_from = {:g} must be below flank_to = {:g}.",
                                          keys.low, keys.high));
  return [keys](const std::filesystem::path& results) { return measure_heap(results, keys); };
}

}  // namespace gasgrain
