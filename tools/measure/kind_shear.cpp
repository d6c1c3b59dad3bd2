// Internal friction angle of grains in steady shear between two plates,
//   phi = atan(mean shear stress / mean normal stress),
// from a shear strain on at which the start is forgotten. The uncertainty is the standard error
// over `blocks` parts of the time.
#include <cmath>

#include "coupling/base/error.h"
#include "tools/measure/kinds.h"
#include "tools/measure/series.h"

namespace gasgrain {

namespace {

constexpr double degree = 180.0 / M_PI;

struct ShearKeys {
  std::string history;
  double from = 0.0;
  int blocks = 0;
};

Measurement measure_shear(const std::filesystem::path& results, const ShearKeys& keys) {
  const auto file = results / keys.history;
  const auto columns =
      read_columns(file, {"shear_strain", "shear_stress_Pa", "normal_stress_Pa", "solid_fraction"});
  std::vector<double> shear;
  std::vector<double> normal;
  std::vector<double> solids;
  Measurement measured;
  measured.curve.columns = {"shear_strain", "stress_ratio", "solid_fraction"};
  for (std::size_t n = 0; n < columns[0].size(); ++n) {
    const double ratio = columns[1][n] / columns[2][n];
    measured.curve.rows.push_back({columns[0][n], ratio, columns[3][n]});
    if (columns[0][n] < keys.from) continue;
    shear.push_back(columns[1][n]);
    normal.push_back(columns[2][n]);
    solids.push_back(columns[3][n]);
  }
  constexpr std::size_t fewest_a_block = 10;
  if (shear.size() < fewest_a_block * static_cast<std::size_t>(keys.blocks))
    fail(
        "{}: {} readings from a shear strain of {:g} on, which ends at {:.3g}, are too few for {} "
        "blocks: shear further.",
        file.string(), shear.size(), keys.from, columns[0].back(), keys.blocks);
  const BlockMean tau = block_mean(shear, keys.blocks);
  const BlockMean sigma = block_mean(normal, keys.blocks);
  if (sigma.value <= 0.0)
    fail("{}: the mean normal stress is {:.3g} Pa: the grains do not carry the plate.",
         file.string(), sigma.value);
  const double ratio = tau.value / sigma.value;
  // d(atan r) = dr / (1 + r^2); the load is steady, so that the shear stress has the error.
  const double error = tau.uncertainty / sigma.value / (1.0 + ratio * ratio);
  const BlockMean share = block_mean(solids, keys.blocks);
  measured.quantities = {
      {"internal_friction_angle", std::atan(ratio) * degree, "degree", error * degree},
      {"solid_fraction", share.value, "1", share.uncertainty}};
  return measured;
}

}  // namespace

Measure read_shear(InputTable& table) {
  ShearKeys keys;
  keys.history = table.text("history", "history.csv");
  keys.from = table.number("from_strain", 0.3, Range::not_negative(), "1");
  keys.blocks = table.integer("blocks", 5, Range::within(2, 100));
  return [keys](const std::filesystem::path& results) { return measure_shear(results, keys); };
}

}  // namespace gasgrain
