// The stress of particles pressed together, and its limiter.
#include <gtest/gtest.h>

#include "fix_cfd_coupling/dem_physics/parcels/parcel_deposit.h"
#include "tests/exchange_model/parcel_cases.h"

namespace gasgrain {
namespace {

constexpr double radius = 0.5e-3;

TEST(particle_stress, is_sniders_and_finite_at_close_packing_and_beyond) {
  const ParcelSettings settings;  // 100 Pa, 3, 1e-7, close packing 0.6
  const ParticleStress stress(settings);
  EXPECT_EQ(stress.stress(0.0), 0.0);
  EXPECT_NEAR(stress.stress(0.5), 100.0 * 0.125 / 0.1, 1e-12);
  EXPECT_NEAR(stress.stress(0.6), 100.0 * 0.216 / (1e-7 * 0.4), 1.0);
  double last = 0.0;
  for (double theta = 0.0; theta < 2.0; theta += 0.01) {
    EXPECT_GE(stress.stress(theta), last);
    EXPECT_TRUE(std::isfinite(stress.stress(theta)));
    last = stress.stress(theta);
  }
}

// Layers of cells from 0.05 to 0.5; the force that would have to be arrested is made so large that
// the limiter has nothing to do.
TEST(particle_stress, presses_all_particles_of_a_volume_with_its_gradient) {
  const BoxGrid grid = box_of({3, 3, 10}, 1e-2);
  Parcels parcels;
  for (int k = 0; k < 10; ++k)
    fill(parcels, grid, {{0, 0, k}, {3, 3, k + 1}}, 2, 0.05 * (k + 1), radius, 2500.0, Vec3::Zero(),
         0.0);
  for (double& v : parcels.v) v = 0.0;
  const TileFrame frame = whole_box(grid);
  ParticleStress stress{ParcelSettings{}};
  std::vector<double> force(3 * parcels.count());
  for (std::size_t p = 0; p < parcels.count(); ++p)
    force[3 * p + 2] = 1e4 * parcels.mass[p];  // upwards, to where it is fuller
  const std::vector<double> others = force;
  const double dt = 1e-4;
  const StressReport report =
      stress.add_forces(parcels.view(), frame, dt, force.data(), sum_of_one_rank(frame));
  Vec3 total = Vec3::Zero();
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    const double z = parcels.x[3 * p + 2] / 1e-2 - 0.5;
    const int below = std::clamp(static_cast<int>(std::floor(z)), 0, 8);
    const Array3<double>& theta = stress.solid_fraction();
    const double slope =
        (stress.stress(theta(1, 1, below + 1)) - stress.stress(theta(1, 1, below))) / 1e-2;
    const double t = std::clamp(z - below, 0.0, 1.0);
    const double theta_here = (1.0 - t) * theta(1, 1, below) + t * theta(1, 1, below + 1);
    const double by_stress = force[3 * p + 2] - others[3 * p + 2];
    EXPECT_NEAR(by_stress, -slope * parcels.solid_volume[p] / theta_here,
                1e-10 * std::abs(by_stress));
    EXPECT_EQ(force[3 * p], 0.0);
    total[2] += dt * parcels.particles[p] * by_stress;
  }
  EXPECT_LT((total - report.impulse).norm(), 1e-12 * total.norm());
  EXPECT_LT(total[2], 0.0);
}

// Random parcels up to and beyond close packing: along each axis the step ends between the velocity
// that is coming and the mean, or beyond the mean by e times the velocity with which they came.
TEST(particle_stress, takes_a_parcel_to_the_mean_or_beyond_by_the_restitution_at_most) {
  for (const double e : {0.0, 0.4, 1.0}) {
    const BoxGrid grid = box_of({6, 6, 6}, 5e-3);
    ParcelSettings settings;
    settings.restitution = e;
    ParticleStress stress(settings);
    Parcels parcels;
    fill(parcels, grid, grid.all(), 2, 0.58, radius, 1000.0, Vec3::Zero());
    CounterRandom random(5, 0, 0);
    for (double& v : parcels.v) v = 0.3 + 0.1 * random.normal();
    std::vector<double> force(3 * parcels.count());
    for (double& f : force) f = 1e-6 * random.normal();
    const std::vector<double> others = force;
    const TileFrame frame = whole_box(grid);
    const double dt = 1e-3;
    const StressReport report =
        stress.add_forces(parcels.view(), frame, dt, force.data(), sum_of_one_rank(frame));
    EXPECT_GT(report.acting, parcels.count() / 2);
    EXPECT_GT(report.limited, 0U);
    Array3<double> mass(frame.tile, 0.0);
    std::array<Array3<double>, 3> momentum{mass, mass, mass};
    for (std::size_t p = 0; p < parcels.count(); ++p) {
      const ParcelStencil stencil = trilinear_axes(frame, parcels.view().x(p));
      deposit(stencil, parcels.view().parcel_mass(p), mass);
      for (int d = 0; d < 3; ++d)
        deposit(stencil, parcels.view().parcel_mass(p) * parcels.v[3 * p + d], momentum[d]);
    }
    int beyond = 0;
    for (std::size_t n = 0; n < force.size(); ++n) {
      const ParcelStencil stencil = trilinear_axes(frame, parcels.view().x(n / 3));
      const double mean = sample(stencil, momentum[n % 3]) / sample(stencil, mass);
      const double coming = parcels.v[n] + dt * others[n] / parcels.mass[n / 3] - mean;
      const double after = parcels.v[n] + dt * force[n] / parcels.mass[n / 3] - mean;
      const double towards = coming > 0.0 ? 1.0 : -1.0;
      EXPECT_LE(after * towards, std::abs(coming) * (1.0 + 1e-12));
      EXPECT_GE(after * towards, -e * std::abs(parcels.v[n] - mean) - 1e-12);
      beyond += after * towards < -1e-9;
    }
    EXPECT_EQ(beyond > 0, e > 0.0);
  }
}

TEST(particle_stress, that_is_off_only_counts_the_solids) {
  const BoxGrid grid = box_of({4, 4, 4}, 5e-3);
  ParcelSettings settings;
  settings.stress = false;
  ParticleStress stress(settings);
  Parcels parcels;
  fill(parcels, grid, grid.all(), 2, 0.5, radius, 1000.0, Vec3::Zero());
  std::vector<double> force(3 * parcels.count(), 1.0);
  const TileFrame frame = whole_box(grid);
  stress.add_forces(parcels.view(), frame, 1e-3, force.data(), sum_of_one_rank(frame));
  for (const double f : force) EXPECT_EQ(f, 1.0);
  double sum = 0.0;
  for (const double theta : stress.solid_fraction()) sum += theta;
  EXPECT_NEAR(sum, 0.5 * 64, 1e-11);
}

}  // namespace
}  // namespace gasgrain
