#include "fix_cfd_coupling/dem_physics/parcels/return_to_isotropy.h"

#include "fix_cfd_coupling/dem_physics/parcels/counter_random.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_deposit.h"

namespace gasgrain {

double ReturnToIsotropy::rate(double frequency) const {
  if (frequency <= 0.0) return 0.0;
  const double eta = 0.5 * (1.0 + restitution);
  return 48.0 / (5.0 * std::sqrt(3.0 * M_PI)) * eta * (2.0 - eta) * frequency;
}

IsotropyReport ReturnToIsotropy::redirect(const ParcelView& parcels,
                                          const std::vector<std::size_t>& cells,
                                          const TileFrame& frame, double dt, std::uint64_t step,
                                          const SumOverRanks& sum) const {
  const CollisionCells before(parcels, cells, frame, close_packing, sum);
  IsotropyReport report;
  for (std::size_t p = 0; p < parcels.count; ++p) {
    const std::size_t c = cells[p];
    const double wanted = -std::expm1(-dt * rate(before.frequency[c]));
    if (wanted > share) ++report.limited;
    CounterRandom random(seed, step, static_cast<std::uint64_t>(parcels.number[p]));
    if (random.uniform() >= std::min(wanted, share)) continue;
    ++report.redirected;
    const double of_component = std::sqrt(before.variance[c] / 3.0);
    for (int d = 0; d < 3; ++d)
      parcels.velocity[3 * p + d] = before.velocity[d][c] + of_component * random.normal();
  }

  // Cells with the momentum and the energy that they had.
  const CollisionCells after(parcels, cells, frame, close_packing, sum);
  for (std::size_t p = 0; p < parcels.count; ++p) {
    const std::size_t c = cells[p];
    if (before.frequency[c] <= 0.0 || after.variance[c] <= 0.0) continue;
    const double scale = std::sqrt(before.variance[c] / after.variance[c]);
    for (int d = 0; d < 3; ++d) {
      double& v = parcels.velocity[3 * p + d];
      v = before.velocity[d][c] + scale * (v - after.velocity[d][c]);
    }
  }
  return report;
}

}  // namespace gasgrain
