// Constrained modulus of grains that are compressed between two plates and cannot give way
// sideways:
//   M = d(stress) / d(strain),   strain = (h_0 - h) / h_0,
// the slope of the least-squares line between two stresses; h_0 is the height at the lower one. The
// uncertainty is that of the line's slope, from its residuals; a packing stiffens as it is
// compressed, so that a wide range of stress has a larger one.
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/kinds.h"
#include "tools/measure/series.h"

namespace gasgrain {

namespace {

struct UniaxialKeys {
  std::string history;
  double from = 0.0;  // Pa
  double to = 0.0;
};

Measurement measure_uniaxial(const std::filesystem::path& results, const UniaxialKeys& keys) {
  const auto file = results / keys.history;
  const auto columns = read_columns(file, {"height_m", "solid_fraction", "stress_Pa"});
  const auto& height = columns[0];
  const auto& solids = columns[1];
  const auto& stress = columns[2];
  // From the last reading below the lower stress to the first above the upper one.
  std::size_t last = 0;
  while (last < stress.size() && stress[last] <= keys.to) ++last;
  std::size_t first = last;
  while (first > 0 && stress[first - 1] >= keys.from) --first;
  constexpr std::size_t fewest = 10;
  if (last == stress.size())
    fail(
        "{}: the stress ends at {:.4g} Pa and never exceeds stress_to = {:g} Pa: compress further.",
        file.string(), stress.back(), keys.to);
  if (last - first < fewest)
    fail(
        "{}: {} readings from {:g} to {:g} Pa are too few for a slope, at least {} are needed: "
        "compress more slowly.",
        file.string(), last - first, keys.from, keys.to, fewest);
  const auto count = static_cast<double>(last - first);
  const auto strain = [&](std::size_t n) { return (height[first] - height[n]) / height[first]; };
  double x = 0.0;
  double y = 0.0;
  for (std::size_t n = first; n < last; ++n) {
    x += strain(n) / count;
    y += stress[n] / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t n = first; n < last; ++n) {
    xx += (strain(n) - x) * (strain(n) - x);
    xy += (strain(n) - x) * (stress[n] - y);
  }
  if (xx <= 0.0) fail("{}: the height does not change while the stress rises.", file.string());
  const double modulus = xy / xx;
  double residual = 0.0;
  Measurement measured;
  measured.curve.columns = {"strain", "stress_Pa", "line_Pa"};
  for (std::size_t n = 0; n < last; ++n) {
    const bool fitted = n >= first;
    const double line = y + modulus * (strain(n) - x);
    if (fitted) residual += (stress[n] - line) * (stress[n] - line);
    measured.curve.rows.push_back(
        {strain(n), stress[n], fitted ? line : std::numeric_limits<double>::quiet_NaN()});
  }
  measured.quantities = {
      {"constrained_modulus", modulus, "Pa", std::sqrt(residual / (count - 2.0) / xx)},
      {"solid_fraction", solids[first], "1", 0.0}};
  return measured;
}

}  // namespace

Measure read_uniaxial(InputTable& table) {
  UniaxialKeys keys;
  keys.history = table.text("history", "history.csv");
  keys.from = table.number("stress_from", std::nullopt, Range::positive(), "Pa");
  keys.to = table.number("stress_to", std::nullopt, Range::positive(), "Pa");
  if (keys.from >= keys.to && !table.at_fault("stress_from") && !table.at_fault("stress_to"))
    table.fault("stress_from", fmt::format("stress_from = {:g} must be below stress_to = {:g}.",
                                           keys.from, keys.to));
  return [keys](const std::filesystem::path& results) { return measure_uniaxial(results, keys); };
}

}  // namespace gasgrain
