// Normal restitution: the velocity away from a plate after an impact over that towards it before,
//   e = -v_z(after) / v_z(before),
// of each grain in the first and the last frame of a dump; the plate is the plane z = 0 beneath.
// A grain that stays on the plate has e = 0. The value is the mean, the uncertainty the standard
// error over the grains, which hit the plate at different speeds.
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/dump_file.h"
#include "tools/measure/kinds.h"

namespace gasgrain {

namespace {

Measurement measure_bounce_dump(const std::filesystem::path& results, const std::string& dump) {
  const auto file = results / dump;
  auto frames = read_dump(file);
  DumpFrame& before = frames.front();
  DumpFrame& after = frames.back();
  if (frames.size() < 2 || before.size() != after.size() || before.size() == 0)
    fail(
        "{}: {} grains before and {} after, in {} frames: the same grains are needed in the first "
        "and in the last frame.",
        file.string(), before.size(), after.size(), frames.size());
  before.sort_by_id();
  after.sort_by_id();
  const std::size_t vz = before.column("vz");
  const std::size_t z = before.column("z");
  const std::size_t radius = before.column("radius");
  Measurement measured;
  measured.curve.columns = {"impact_speed_m_s", "normal_restitution"};
  double sum = 0.0;
  double squares = 0.0;
  int stuck = 0;
  for (std::size_t n = 0; n < before.size(); ++n) {
    const double speed = -before.value(n, vz);
    if (speed <= 0.0)
      fail("{}: grain {} moves away from the plate in the first frame, at {:g} m/s.", file.string(),
           n + 1, -speed);
    double rebound = after.value(n, vz);
    if (rebound < 0.0 && after.value(n, z) > after.value(n, radius))
      fail("{}: grain {} has not come to the plate by the end: make the run longer.", file.string(),
           n + 1);
    const bool touches = after.value(n, z) < after.value(n, radius);
    if (touches && std::abs(rebound) > 1e-3 * speed)
      fail("{}: grain {} is in touch with the plate at the end: make the run longer.",
           file.string(), n + 1);
    if (touches) {
      ++stuck;
      rebound = 0.0;
    }
    const double e = rebound / speed;
    measured.curve.rows.push_back({speed, e});
    sum += e;
    squares += e * e;
  }
  const auto count = static_cast<double>(before.size());
  const double spread = std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
  measured.quantities = {
      {"normal_restitution", sum / count, "1", spread / std::sqrt(std::max(1.0, count - 1.0))}};
  if (stuck > 0)
    measured.notes.push_back(fmt::format("{} of {} grains stayed on the plate, with restitution 0.",
                                         stuck, before.size()));
  return measured;
}

}  // namespace

Measure read_bounce(InputTable& table) {
  const std::string dump = table.text("dump", "particles/bounce.dump");
  return
      [dump](const std::filesystem::path& results) { return measure_bounce_dump(results, dump); };
}

}  // namespace gasgrain
