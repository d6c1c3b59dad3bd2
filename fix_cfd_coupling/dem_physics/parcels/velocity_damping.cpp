#include "fix_cfd_coupling/dem_physics/parcels/velocity_damping.h"

namespace gasgrain {

double VelocityDamping::rate(double frequency) const {
  const double eta = 0.5 * (1.0 + restitution);
  // Elastic particles lose nothing, at close packing either.
  if (eta >= 1.0 || frequency <= 0.0) return 0.0;
  return 16.0 / std::sqrt(3.0 * M_PI) * eta * (1.0 - eta) * frequency;
}

double VelocityDamping::damp(const ParcelView& parcels, const std::vector<std::size_t>& cells,
                             const TileFrame& frame, double dt, const SumOverRanks& sum) const {
  const CollisionCells means(parcels, cells, frame, close_packing, sum);
  double lost = 0.0;
  for (std::size_t p = 0; p < parcels.count; ++p) {
    const std::size_t c = cells[p];
    const double kept = 1.0 / std::sqrt(1.0 + dt * rate(means.frequency[c]));
    if (kept == 1.0) continue;
    const double half_mass = 0.5 * parcels.parcel_mass(p);
    for (int d = 0; d < 3; ++d) {
      double& v = parcels.velocity[3 * p + d];
      const double mean = means.velocity[d][c];
      const double damped = mean + kept * (v - mean);
      lost += half_mass * (v * v - damped * damped);
      v = damped;
    }
  }
  return lost;
}

}  // namespace gasgrain
