// What holds two bodies together that are pulled apart, of force over gap:
//   greatest force, the gap s_c at which it ends, and the work of the pull, integral_0^s_c F ds.
// Read are gaps from 0 on. The uncertainty is what lies between two readings: of s_c half of their
// distance, of the work that times the last force.
#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/kinds.h"
#include "tools/measure/series.h"

namespace gasgrain {

namespace {

Measurement measure_pull(const std::filesystem::path& results, const std::string& history) {
  const auto file = results / history;
  const auto columns = read_columns(file, {"gap_m", "force_N"});
  std::vector<double> gap;
  std::vector<double> force;
  for (std::size_t n = 0; n < columns[0].size(); ++n) {
    if (columns[0][n] < 0.0) continue;
    if (!gap.empty() && columns[0][n] <= gap.back())
      fail("{}: the gap falls from {:g} to {:g} m: a pull only goes apart.", file.string(),
           gap.back(), columns[0][n]);
    gap.push_back(columns[0][n]);
    force.push_back(columns[1][n]);
  }
  if (gap.empty()) fail("{}: no gap is 0 or more: the bodies stay in contact.", file.string());
  const double greatest = *std::max_element(force.begin(), force.end());
  if (!(greatest > 0.0))
    fail("{}: nothing holds the bodies together at a gap: the force is {:g} N at most.",
         file.string(), greatest);
  std::size_t last = force.size() - 1;
  while (!(force[last] > 0.0)) --last;
  if (last + 1 == force.size())
    fail("{}: at {:g} m, the last gap, the bodies still attract by {:g} N: pull further.",
         file.string(), gap.back(), force.back());
  constexpr std::size_t fewest = 20;
  if (last + 1 < fewest)
    fail(
        "{}: {} readings before the force ends are too few, at least {} are needed: pull more "
        "slowly.",
        file.string(), last + 1, fewest);
  Measurement measured;
  measured.curve.columns = {"gap_m", "force_N"};
  for (std::size_t n = 0; n < gap.size(); ++n) measured.curve.rows.push_back({gap[n], force[n]});
  const double half = 0.5 * (gap[last + 1] - gap[last]);
  // The first reading's force is also that of touch, the last one's that of the end.
  double work = force.front() * gap.front() + half * force[last];
  for (std::size_t n = 0; n < last; ++n)
    work += 0.5 * (force[n] + force[n + 1]) * (gap[n + 1] - gap[n]);
  measured.quantities = {{"greatest_force", greatest, "N", 0.0},
                         {"rupture_distance", gap[last] + half, "m", half},
                         {"pull_energy", work, "J", half * force[last]}};
  return measured;
}

}  // namespace

Measure read_pull(InputTable& table) {
  const std::string history = table.text("history", "history.csv");
  return [history](const std::filesystem::path& results) { return measure_pull(results, history); };
}

}  // namespace gasgrain
