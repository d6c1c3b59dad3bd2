#include "fix_cfd_coupling/dem_physics/parcels/particle_stress.h"

#include "fix_cfd_coupling/dem_physics/parcels/parcel_deposit.h"

namespace gasgrain {

namespace {

// The gradient of the trilinear interpolation of a field; in the half cell along a wall, where the
// stencil is folded, the difference goes on as it is between the first two centres.
Vec3 gradient(const TileFrame& frame, const Vec3& x, const ParcelStencil& stencil,
              const Array3<double>& field) {
  const Vec3 h = frame.grid.spacing();
  Vec3 slope = Vec3::Zero();
  for (int d = 0; d < 3; ++d) {
    int below = static_cast<int>(std::floor(frame.in_cells(x[d], d) - 0.5));
    if (!frame.grid.periodic[d]) {
      if (frame.grid.cells[d] < 2) continue;
      below = std::clamp(below, 0, frame.grid.cells[d] - 2);
    }
    if (below < frame.tile.lo[d] || below + 1 >= frame.tile.hi[d]) continue;
    ParcelStencil across = stencil;
    across[d] = {};
    across[d].add(below, -1.0 / h[d]);
    across[d].add(below + 1, 1.0 / h[d]);
    slope[d] = sample(across, field);
  }
  return slope;
}

double minmod(double a, double b) {
  if (a * b <= 0.0) return 0.0;
  return std::abs(a) < std::abs(b) ? a : b;
}

}  // namespace

double ParticleStress::bound(double mean, double was, double coming) const {
  const double stop = mean - coming;
  const double approach = mean - was;
  return stop * approach > 0.0 ? stop + restitution_ * approach : stop;
}

ParticleStress::ParticleStress(const ParcelSettings& settings)
    : close_packing_(settings.close_packing),
      constant_(settings.stress_constant),
      exponent_(settings.stress_exponent),
      epsilon_(settings.stress_epsilon),
      restitution_(settings.restitution),
      on_(settings.stress) {}

double ParticleStress::stress(double fraction) const {
  if (fraction <= 0.0) return 0.0;
  const double room = std::max(close_packing_ - fraction,
                               epsilon_ * std::max(1.0 - fraction, 1.0 - close_packing_));
  return constant_ * std::pow(fraction, exponent_) / room;
}

void ParticleStress::deposit(const ParcelView& parcels, const TileFrame& frame,
                             const SumOverRanks& sum) {
  const double per_volume = 1.0 / frame.grid.cell_volume();
  std::vector<Array3<double>*> fields{&fraction_};
  if (on_) fields = {&fraction_, &filled_, &mass_, &momentum_[0], &momentum_[1], &momentum_[2]};
  for (Array3<double>* field : fields) clear(*field, frame);
  for (std::size_t p = 0; p < parcels.count; ++p) {
    const Vec3 x = parcels.x(p);
    if (frame.beyond_walls(x)) continue;
    const ParcelStencil stencil = stencil_within(frame, x);
    const double solids = parcels.solids(p) * per_volume;
    if (!on_) {
      gasgrain::deposit(stencil, solids, fraction_);
      continue;
    }
    const double volume = parcels.particles[p] * parcels.particle_volume(p) * per_volume;
    const double mass = parcels.parcel_mass(p);
    const Vec3 momentum = mass * parcels.v(p);
    for_each_product(stencil, [&](int i, int j, int k, double w) {
      const std::ptrdiff_t n = fraction_.offset(i, j, k);
      fraction_[n] += w * solids;
      filled_[n] += w * volume;
      mass_[n] += w * mass;
      for (int d = 0; d < 3; ++d) momentum_[d][n] += w * momentum[d];
    });
  }
  sum(fields);
}

StressReport ParticleStress::add_forces(const ParcelView& parcels, const TileFrame& frame,
                                        double dt, double* force, const SumOverRanks& sum) {
  deposit(parcels, frame, sum);
  StressReport report;
  for (const double fraction : fraction_)
    report.greatest_fraction = std::max(report.greatest_fraction, fraction);
  if (!on_) return report;
  report.greatest_stress = stress(report.greatest_fraction);
  clear(stress_, frame);
  for (std::size_t n = 0; n < stress_.size(); ++n) stress_[n] = stress(fraction_[n]);

  for (std::size_t p = 0; p < parcels.count; ++p) {
    const Vec3 x = parcels.x(p);
    if (frame.beyond_walls(x)) continue;
    const ParcelStencil stencil = trilinear_axes(frame, x);
    const double filled = sample(stencil, filled_);
    const double mass_here = sample(stencil, mass_);
    if (filled <= 0.0 || mass_here <= 0.0) continue;
    const Vec3 slope = gradient(frame, x, stencil, stress_);
    const double mass = parcels.mass[p];
    for (int d = 0; d < 3; ++d) {
      const double by_stress = -dt * slope[d] * parcels.particle_volume(p) / (filled * mass);
      const double mean = sample(stencil, momentum_[d]) / mass_here;
      const double was = parcels.velocity[3 * p + d];
      const double coming = was + dt * force[3 * p + d] / mass;
      const double change = minmod(by_stress, bound(mean, was, coming));
      if (change != by_stress) ++report.limited;
      if (change == 0.0) continue;
      ++report.acting;
      force[3 * p + d] += mass * change / dt;
      report.impulse[d] += parcels.particles[p] * mass * change;
    }
  }
  return report;
}

}  // namespace gasgrain
