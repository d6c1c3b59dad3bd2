// Damping and return to isotropy by collisions: what they conserve, and how fast they are.
#include <gtest/gtest.h>

#include "fix_cfd_coupling/dem_physics/parcels/return_to_isotropy.h"
#include "fix_cfd_coupling/dem_physics/parcels/velocity_damping.h"
#include "tests/exchange_model/parcel_cases.h"

namespace gasgrain {
namespace {

constexpr double radius = 0.5e-3;
constexpr double packed = 0.6;

struct Gas {
  BoxGrid grid = box_of({2, 2, 2}, 5e-3);
  TileFrame frame = whole_box(grid);
  Parcels parcels;
  std::vector<std::size_t> cells;
  SumOverRanks sum = sum_of_one_rank(frame);

  // along^3 parcels a cell of different particles, with the deviation of each velocity component.
  Gas(double theta, int along, const Vec3& deviation) {
    fill(parcels, grid, grid.all(), along, theta, radius, 2500.0, Vec3::Zero());
    CounterRandom random(21, 0, 0);
    for (std::size_t p = 0; p < parcels.count(); ++p)
      for (int d = 0; d < 3; ++d) parcels.v[3 * p + d] = 0.7 + deviation[d] * random.normal();
    cells = parcel_cells(parcels.view(), frame);
  }
  void mix_sizes() {
    CounterRandom random(22, 0, 0);
    for (std::size_t p = 0; p < parcels.count(); ++p) parcels.particles[p] *= random.uniform();
  }
  CollisionCells means() { return {parcels.view(), cells, frame, packed, sum}; }
  Array3<double> energy(int axis) {
    Array3<double> field(frame.tile, 0.0);
    const CollisionCells now = means();
    for (std::size_t p = 0; p < parcels.count(); ++p) {
      const double v = parcels.v[3 * p + axis] - now.velocity[axis][cells[p]];
      field[cells[p]] += parcels.particles[p] * parcels.mass[p] * v * v / now.mass[cells[p]];
    }
    return field;
  }
};

TEST(velocity_damping, loses_energy_as_kinetic_theory_says) {
  for (const double theta : {0.1, 0.5}) {
    Gas gas(theta, 4, Vec3::Constant(0.1));
    const double e = 0.9;
    const VelocityDamping damping{e, packed};
    const CollisionCells before = gas.means();
    const double dt = 1e-7;
    const double lost = damping.damp(gas.parcels.view(), gas.cells, gas.frame, dt, gas.sum);
    double expected = 0.0;
    for (std::size_t c = 0; c < before.mass.size(); ++c) {
      // Lun et al.: 12 (1 - e^2) theta^2 rho g_0 T^(3/2) / (d pi^(1/2)) of a volume, T = sigma^2/3.
      const double share = before.mass[c] / 2500.0 / gas.grid.cell_volume();
      const double g0 = packed / (packed - share);
      const double T = before.variance[c] / 3.0;
      expected += dt * gas.grid.cell_volume() * 12.0 * (1.0 - e * e) * share * share * 2500.0 * g0 *
                  std::pow(T, 1.5) / (2.0 * radius * std::sqrt(M_PI));
    }
    // The step falls short of the rate by dt/tau_D, 3e-5 at most.
    EXPECT_NEAR(lost / expected, 1.0, 5e-5) << theta;
  }
}

// sigma^2 = sigma_0^2 / (1 + t / (2 tau_0))^2, Haff's law, as 1/tau_D goes with sigma.
TEST(velocity_damping, cools_after_haffs_law_with_first_order_in_the_step) {
  std::vector<double> errors;
  for (const int steps : {50, 100, 200}) {
    Gas gas(0.3, 3, Vec3::Constant(0.2));
    const VelocityDamping damping{0.8, packed};
    const CollisionCells before = gas.means();
    const double end = 0.1;
    for (int n = 0; n < steps; ++n)
      damping.damp(gas.parcels.view(), gas.cells, gas.frame, end / steps, gas.sum);
    const CollisionCells after = gas.means();
    double worst = 0.0;
    for (std::size_t c = 0; c < before.mass.size(); ++c) {
      const double x = 1.0 + 0.5 * end * damping.rate(before.frequency[c]);
      worst = std::max(worst, std::abs(after.variance[c] * x * x / before.variance[c] - 1.0));
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors.back(), 0.05);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1.0, 0.15);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 1.0, 0.15);
}

TEST(velocity_damping, keeps_the_momentum_of_each_cell_and_stops_at_close_packing) {
  for (const double theta : {0.2, 0.6, 0.7}) {
    Gas gas(theta, 2, Vec3(0.3, 0.1, 0.2));
    const CollisionCells before = gas.means();
    VelocityDamping{0.9, packed}.damp(gas.parcels.view(), gas.cells, gas.frame, 1e-3, gas.sum);
    const CollisionCells after = gas.means();
    for (std::size_t c = 0; c < before.mass.size(); ++c) {
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(after.velocity[d][c], before.velocity[d][c], 1e-15);
      if (theta > 0.59)
        EXPECT_LT(after.variance[c], 1e-25);
      else
        EXPECT_GT(after.variance[c], 0.0);
      EXPECT_LT(after.variance[c], before.variance[c]);
    }
  }
}

TEST(velocity_damping, does_nothing_to_elastic_grains_single_parcels_and_parcels_at_rest) {
  Gas gas(0.7, 2, Vec3::Constant(0.1));
  const std::vector<double> v = gas.parcels.v;
  EXPECT_EQ(
      (VelocityDamping{1.0, packed}.damp(gas.parcels.view(), gas.cells, gas.frame, 1.0, gas.sum)),
      0.0);
  EXPECT_EQ(gas.parcels.v, v);
  Gas single(0.7, 1, Vec3::Constant(0.1));
  const std::vector<double> w = single.parcels.v;
  VelocityDamping{0.5, packed}.damp(single.parcels.view(), single.cells, single.frame, 1.0,
                                    single.sum);
  ReturnToIsotropy{0.5, 1.0, packed, 1}.redirect(single.parcels.view(), single.cells, single.frame,
                                                 1.0, 0, single.sum);
  EXPECT_EQ(single.parcels.v, w);
  Gas rest(0.7, 2, Vec3::Zero());
  const std::vector<double> r = rest.parcels.v;
  ReturnToIsotropy{0.5, 1.0, packed, 1}.redirect(rest.parcels.view(), rest.cells, rest.frame, 1.0,
                                                 0, rest.sum);
  for (std::size_t n = 0; n < r.size(); ++n) EXPECT_NEAR(rest.parcels.v[n], r[n], 1e-15);
}

TEST(return_to_isotropy, keeps_momentum_and_energy_of_each_cell) {
  Gas gas(0.4, 3, Vec3(0.5, 0.0, 0.1));
  gas.mix_sizes();
  const CollisionCells before = gas.means();
  std::size_t redirected = 0;
  for (std::uint64_t step = 0; step < 20; ++step)
    redirected += ReturnToIsotropy{0.9, 0.4, packed, 5}
                      .redirect(gas.parcels.view(), gas.cells, gas.frame, 1e-3, step, gas.sum)
                      .redirected;
  EXPECT_GT(redirected, gas.parcels.count());
  const CollisionCells after = gas.means();
  for (std::size_t c = 0; c < before.mass.size(); ++c) {
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(after.velocity[d][c], before.velocity[d][c], 1e-13);
    EXPECT_NEAR(after.variance[c] / before.variance[c], 1.0, 1e-13);
  }
}

TEST(return_to_isotropy, evens_the_directions_out_at_its_rate) {
  // 8000 parcels a cell scatter the energy of a direction by 2 %.
  Gas gas(0.2, 20, Vec3(0.0, 0.0, 0.3));
  const ReturnToIsotropy isotropy{0.9, 1.0, packed, 5};
  const CollisionCells before = gas.means();
  const double rate = isotropy.rate(before.frequency[0]);
  // eta = 0.95: 48 / (5 (3 pi)^(1/2)) 0.95 1.05 of the frequency.
  EXPECT_NEAR(rate / before.frequency[0], 48.0 / 5.0 / std::sqrt(3.0 * M_PI) * 0.9975, 1e-12);
  const int steps = 20;
  const double dt = 1.0 / rate / steps;
  for (int n = 0; n < steps; ++n)
    isotropy.redirect(gas.parcels.view(), gas.cells, gas.frame, dt, n, gas.sum);
  // The energy of z is 1/3 + 2/3 exp(-t/tau_G) of all.
  const Array3<double> along = gas.energy(2);
  for (std::size_t c = 0; c < along.size(); ++c) {
    const double cell = isotropy.rate(before.frequency[c]) / rate;
    EXPECT_NEAR(along[c] / before.variance[c], 1.0 / 3.0 + 2.0 / 3.0 * std::exp(-cell), 0.03);
  }
}

TEST(return_to_isotropy, redirects_no_more_than_its_share_and_counts_where_it_wants_more) {
  Gas gas(0.59, 10, Vec3(0.0, 0.0, 1.0));
  const IsotropyReport report = ReturnToIsotropy{0.9, 0.4, packed, 5}.redirect(
      gas.parcels.view(), gas.cells, gas.frame, 1e-2, 0, gas.sum);
  EXPECT_EQ(report.limited, gas.parcels.count());
  // 8000 parcels: a deviation of 0.55 %.
  EXPECT_NEAR(static_cast<double>(report.redirected) / gas.parcels.count(), 0.4, 0.02);
}

// Film takes voids: (17).
TEST(collision_cells, pack_wet_grains_as_their_cores_do) {
  Gas gas(0.5, 2, Vec3::Constant(0.1));
  for (double& r : gas.parcels.radius) r *= std::cbrt(1.1);
  const CollisionCells wet = gas.means();
  for (std::size_t c = 0; c < wet.mass.size(); ++c)
    EXPECT_NEAR(
        wet.frequency[c],
        0.55 * 0.66 / (0.66 - 0.55) * std::sqrt(wet.variance[c]) / (radius * std::cbrt(1.1)),
        1e-9 * wet.frequency[c]);
}

}  // namespace
}  // namespace gasgrain
