#include "gas_solver/mass_source.h"

namespace gasgrain {
namespace {

double common_volume(const Vec3& lo, const Vec3& hi, const MassSource& source) {
  return (hi.cwiseMin(source.hi) - lo.cwiseMax(source.lo)).cwiseMax(0.0).prod();
}

}  // namespace

Array3<double> mass_source_field(const Domain& domain, const std::vector<MassSource>& sources) {
  Array3<double> field(domain.own());
  const BoxGrid& grid = domain.grid();
  const Vec3 h = grid.spacing();
  for (const MassSource& source : sources) {
    const double density =
        source.rate / (common_volume(grid.lo, grid.hi, source) * grid.cell_volume());
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const Vec3 lo = grid.lo + h.cwiseProduct(Vec3(i, j, k));
      field(i, j, k) += density * common_volume(lo, lo + h, source);
    });
  }
  return field;
}

}  // namespace gasgrain
