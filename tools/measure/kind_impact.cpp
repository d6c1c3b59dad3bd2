// What oblique impacts on the plate z = 0 give back, over their angle of incidence.
//
// Of each grain, from the first and the last frame of a dump, with v_n, v_t the velocities towards
// and along the plate before, a dash for after, R its radius, w its spin about the axis across:
//   angle of incidence   theta = atan(v_t / v_n)
//   normal restitution   e_n = v_n' / v_n
//   tangential one       e_t = v_t' / v_t            (of the centre)
//   rebound angle        theta' = atan(v_t' / v_n')
//   rebound spin         w', positive as of a ball that rolls on
//   impulse ratio        f = (v_t - v_t') / ((1 + e_n) v_n)
// A grain that slides throughout has f = mu, its coefficient of friction (Walton 1993; Foerster,
// Louge, Chang, Allia 1994), hence e_t = 1 - mu (1 + e_n) / tan(theta). Where friction stops the
// contact point, its velocity v_t - w R turns round by a part b of it, and e_t = 1 - 2 (1 + b) / 7
// of a homogeneous sphere: 5/7 with b = 0. Reported at one angle of incidence: the grains beside it
// are interpolated. `sliding_friction` is the mean of f from `sliding_from` on, its uncertainty the
// standard error.
#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/dump_file.h"
#include "tools/measure/kinds.h"

namespace gasgrain {

namespace {

constexpr double degree = 180.0 / M_PI;

struct ImpactKeys {
  std::string dump;
  double angle = 0.0;         // degree
  double sliding_from = 0.0;  // degree
};

struct Impact {
  double angle = 0.0;  // degree
  double normal = 0.0;
  double tangential = 0.0;
  double rebound_angle = 0.0;  // degree
  double spin = 0.0;           // rad/s
  double impulse_ratio = 0.0;
  double turned_round = 0.0;  // b
};

Impact impact(const DumpFrame& before, const DumpFrame& after, std::size_t n) {
  const auto start = [&](const char* name) { return before.value(n, before.column(name)); };
  const auto end = [&](const char* name) { return after.value(n, after.column(name)); };
  const double v_n = -start("vz");
  const double v_t = start("vx");
  const double radius = start("radius");
  if (v_n <= 0.0 || v_t <= 0.0)
    fail("grain {} does not fly down and along x in the first frame: vx = {:g}, vz = {:g} m/s.",
         n + 1, v_t, -v_n);
  if (end("vz") <= 0.0 || end("z") < radius)
    fail("grain {} is not on its way back in the last frame: make the run longer.", n + 1);
  Impact one;
  one.angle = std::atan2(v_t, v_n) * degree;
  one.normal = end("vz") / v_n;
  one.tangential = end("vx") / v_t;
  one.rebound_angle = std::atan2(end("vx"), end("vz")) * degree;
  one.spin = end("omegay");
  one.impulse_ratio = (v_t - end("vx")) / ((1.0 + one.normal) * v_n);
  const double slip = v_t - start("omegay") * radius;
  one.turned_round = -(end("vx") - end("omegay") * radius) / slip;
  return one;
}

// Between the two impacts beside the angle.
double at_angle(const std::vector<Impact>& impacts, double angle, double Impact::*what) {
  std::size_t n = 1;
  while (n + 1 < impacts.size() && impacts[n].angle < angle) ++n;
  const Impact& low = impacts[n - 1];
  const Impact& high = impacts[n];
  const double share = (angle - low.angle) / (high.angle - low.angle);
  return low.*what + share * (high.*what - low.*what);
}

struct Mean {
  double value = 0.0;
  double error = 0.0;
};

Mean mean_of(const std::vector<Impact>& impacts, double from, double Impact::*what) {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const auto& one : impacts) {
    if (one.angle < from) continue;
    ++count;
    sum += one.*what;
    squares += one.*what * (one.*what);
  }
  if (count < 3) fail("{} impacts from {:g} degrees on: at least 3 are needed.", count, from);
  return {sum / count,
          std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1.0) / count)};
}

Measurement measure_impacts(const std::vector<Impact>& impacts, const ImpactKeys& keys) {
  if (keys.angle < impacts.front().angle || keys.angle > impacts.back().angle)
    fail("impact_angle = {:g} is outside of the impacts, {:.3g} to {:.3g} degrees.", keys.angle,
         impacts.front().angle, impacts.back().angle);
  const Mean normal = mean_of(impacts, 0.0, &Impact::normal);
  const Mean friction = mean_of(impacts, keys.sliding_from, &Impact::impulse_ratio);
  Measurement measured;
  measured.quantities = {
      {"tangential_restitution", at_angle(impacts, keys.angle, &Impact::tangential), "1", 0.0},
      {"rebound_angle", at_angle(impacts, keys.angle, &Impact::rebound_angle), "degree", 0.0},
      {"rebound_spin", at_angle(impacts, keys.angle, &Impact::spin), "rad/s", 0.0},
      {"normal_restitution", normal.value, "1", normal.error},
      {"sliding_friction", friction.value, "1", friction.error}};
  constexpr double alike = 0.02;
  for (const auto& one : impacts)
    if (one.angle >= keys.sliding_from &&
        std::abs(one.impulse_ratio / friction.value - 1.0) > alike) {
      measured.notes.push_back(
          fmt::format("the impulse ratio at {:.3g} degrees, {:.3g}, differs from the mean: not all "
                      "impacts from sliding_from on slide throughout.",
                      one.angle, one.impulse_ratio));
      break;
    }
  measured.curve.columns = {"impact_angle_degree",       "normal_restitution",
                            "tangential_restitution",    "rebound_angle_degree",
                            "rebound_spin_rad_s",        "impulse_ratio",
                            "contact_point_restitution", "sliding_line"};
  for (const auto& one : impacts)
    measured.curve.rows.push_back(
        {one.angle, one.normal, one.tangential, one.rebound_angle, one.spin, one.impulse_ratio,
         one.turned_round,
         1.0 - friction.value * (1.0 + normal.value) / std::tan(one.angle / degree)});
  return measured;
}

Measurement measure_impact_dump(const std::filesystem::path& results, const ImpactKeys& keys) {
  const auto file = results / keys.dump;
  auto frames = read_dump(file);
  DumpFrame& before = frames.front();
  DumpFrame& after = frames.back();
  if (frames.size() < 2 || before.size() != after.size() || before.size() < 2)
    fail(
        "{}: {} grains before and {} after, in {} frames: the same grains, at least 2, are needed "
        "in the first and in the last frame.",
        file.string(), before.size(), after.size(), frames.size());
  before.sort_by_id();
  after.sort_by_id();
  try {
    std::vector<Impact> impacts;
    for (std::size_t n = 0; n < before.size(); ++n) impacts.push_back(impact(before, after, n));
    std::sort(impacts.begin(), impacts.end(),
              [](const Impact& a, const Impact& b) { return a.angle < b.angle; });
    return measure_impacts(impacts, keys);
  } catch (const Error& e) {
    fail("{}: {}", file.string(), e.what());
  }
}

}  // namespace

Measure read_impact(InputTable& table) {
  ImpactKeys keys;
  keys.dump = table.text("dump", "particles/impact.dump");
  keys.angle = table.number("impact_angle", 45.0, Range::within(0.0, 90.0), "degree");
  keys.sliding_from = table.number("sliding_from", 70.0, Range::within(0.0, 90.0), "degree");
  return
      [keys](const std::filesystem::path& results) { return measure_impact_dump(results, keys); };
}

}  // namespace gasgrain
