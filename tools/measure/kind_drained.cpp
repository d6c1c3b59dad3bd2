// Angle of repose of a drained box: the slope from a wall down to the edge of a slot.
//
// What is seen from above is fitted over x where the mean profile lies between two shares of its
// greatest height. The uncertainty is the standard error of the angles of strips along the slope.
#include <algorithm>

#include "coupling/base/error.h"
#include "tools/measure/at_rest.h"
#include "tools/measure/kinds.h"
#include "tools/measure/slope.h"

namespace gasgrain {

namespace {

struct DrainedKeys {
  std::string dump;
  double low = 0.0;
  double high = 0.0;
  double floor = 0.0;
  int strips = 0;
};

Measurement measure_drained(const std::filesystem::path& results, const DrainedKeys& keys) {
  const auto file = results / keys.dump;
  const DumpFrame frame = read_dump(file).back();
  const auto grains = grains_above(keys.floor, frame, file,
                                   "the box is empty. Take more friction or a narrower slot.");
  const Extent extent = extent_of(grains);
  auto points = seen_from_above(grains, extent.box, extent.diameter / points_per_grain, keys.floor);
  for (auto& point : points) {
    point.s = point.position.x() - extent.box.x_lo;
    const double share =
        (point.position.y() - extent.box.y_lo) / (extent.box.y_hi - extent.box.y_lo);
    point.part = std::min(keys.strips - 1, static_cast<int>(share * keys.strips));
  }
  const Flank flank =
      fitted_flank(points, {keys.low, keys.high, extent.diameter, keys.floor, keys.strips});
  Measurement measured;
  measured.quantities = {
      {"angle_of_repose", flank.angle_degree, "degree", flank.uncertainty_degree}};
  measured.curve = flank.profile;
  if (const auto note = motion_note(frame, keys.floor); !note.empty())
    measured.notes.push_back(note);
  return measured;
}

}  // namespace

Measure read_drained(InputTable& table) {
  DrainedKeys keys;
  keys.dump = table.text("dump", "particles/slope.dump");
  keys.low = table.number("flank_from", 0.1, Range::within(0.0, 1.0), "1");
  keys.high = table.number("flank_to", 0.9, Range::within(0.0, 1.0), "1");
  keys.floor = table.number("floor", 0.0, Range::any(), "m");
  keys.strips = table.integer("strips", 4, Range::within(2, 36));
  if (keys.low >= keys.high)
    table.fault("flank_from", fmt::format("flank_from = {:g} must be below flank_to = {:g}.",
                                          keys.low, keys.high));
  return [keys](const std::filesystem::path& results) { return measure_drained(results, keys); };
}

}  // namespace gasgrain
