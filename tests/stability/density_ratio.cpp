// Grains as dense as the fluid, and up to 1e4 times as dense.
//
// A random suspension in a periodic box of water: the weight of the grains drives them down, an
// equal force on the fluid drives it up. Whatever the density, they end at the slip at which the
// law's drag is the weight, with a total momentum of nothing, and never pass it by much. Coupling
// intervals are 0.1 and 10 of the time in which the slip relaxes, m / K / (1 + m / m_fluid).
#include <gtest/gtest.h>

#include "tests/stability/explicit_drag.h"

namespace gasgrain::stability {
namespace {

constexpr double diameter = 1e-3;
constexpr double solids = 0.1;
constexpr double slip = 1e-3;  // that of the law [m/s]: a Reynolds number of 1
constexpr double water = 1000.0;
constexpr const char* effects = "drag di_felice void_fraction trilinear virtual_mass";

struct Suspension {
  GasInput input = gas_cases::box({5, 5, 5}, Vec3::Constant(10 * diameter), all_periodic);
  Cloud cloud;
  Pace pace;
  Vec3 weight = Vec3::Zero();
  int couplings = 0;

  Suspension(double ratio, double interval_over_relaxation) {
    input.density = water;
    input.viscosity = 1e-3;
    input.tolerance = 1e-10;
    input.step = 1e9;
    input.courant_max = 1e300;
    const double volume = sphere_volume(0.5 * diameter);
    const auto count = static_cast<int>(solids * input.grid.hi.prod() / volume);
    Random random(9);
    for (int p = 0; p < count; ++p)
      cloud.add(random.vector(input.grid.lo, input.grid.hi), Vec3::Zero(), 0.5 * diameter,
                ratio * water * volume);
    const double K =
        DragDiFelice::coefficient({water, input.viscosity}, 1.0 - solids, slip, diameter);
    const double acceleration = K * slip / cloud.mass[0];
    const double loading = ratio * solids / (1.0 - solids);
    weight = Vec3(0.0, 0.0, -acceleration);
    input.gravity = -loading * weight;
    const double relaxation = cloud.mass[0] / K / (1.0 + loading);
    pace.interval = interval_over_relaxation * relaxation;
    pace.steps = 4;
    couplings = std::max(60, static_cast<int>(10.0 / interval_over_relaxation));
  }
};

constexpr std::array<double, 6> ratios{1.0, 1.05, 10.0, 1e2, 1e3, 1e4};

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

// Mean of the fluid less that of the grains [m/s].
double mean_slip(const CoupledBed& bed) {
  double fluid = 0.0;
  for (const double eps : bed.gas().void_fraction()) fluid += eps;
  fluid *= water * bed.gas().grid().cell_volume();
  return gas_momentum(bed.gas(), water)[2] / fluid -
         bed.grain_momentum()[2] / sum_of(bed.cloud.mass);
}

TEST(density_ratio, from_1_to_1e4_ends_at_the_slip_of_the_law) {
  for (const double ratio : ratios)
    for (const double interval : {0.1, 10.0}) {
      SCOPED_TRACE("density ratio " + std::to_string(ratio) + ", interval of " +
                   std::to_string(interval) + " relaxation times");
      Suspension scene(ratio, interval);
      CoupledBed bed(scene.input, effects, scene.pace, scene.cloud);
      bed.weight = scene.weight;
      double greatest = 0.0;
      for (int n = 0; n < scene.couplings; ++n) {
        bed.advance();
        greatest = std::max(greatest, mean_slip(bed));
        // The nearest that grains of a random suspension come to each other.
        ASSERT_GT(least_void_fraction(bed.gas()), 0.5) << n;
        ASSERT_LT(bed.report().continuity_residual, 1e-8) << n;
      }
      const double last = mean_slip(bed);
      std::printf(
          "density ratio %g, interval %g relaxation times: slip %.3f of the law's, at most %.3f\n",
          ratio, interval, last / slip, greatest / slip);
      // Grains stand at random: the law's mean is not the law of the mean. In long intervals they
      // feel the fluid of where they were.
      const double more = interval < 1.0 ? 0.1 : 0.35;
      EXPECT_GT(last, 0.98 * slip);
      EXPECT_LT(last, (1.0 + more) * slip);
      EXPECT_LT(greatest, (1.0 + more) * slip);
      EXPECT_LT(bed.fastest_grain(), 2.0 * slip);
      EXPECT_LT(bed.ledger().residual(), 1e-12);
    }
}

TEST(density_ratio, whatever_it_is_explicit_drag_runs_away_at_the_longer_interval) {
  for (const double ratio : ratios) {
    Suspension scene(ratio, 10.0);
    for (std::size_t p = 0; p < scene.cloud.radius.size(); ++p)
      scene.cloud.velocity[3 * p + 2] = -slip;
    scene.input.gravity = Vec3::Zero();
    ExplicitBed bed(scene.input, "drag di_felice void_fraction trilinear", scene.pace.interval,
                    scene.cloud);
    for (int n = 0; n < 5; ++n) bed.advance();
    const double fastest = std::max(bed.fastest_grain(), gas_cases::greatest_speed(bed.gas()));
    std::printf("density ratio %g, explicit drag: %.3g times the first slip\n", ratio,
                fastest / slip);
    EXPECT_GT(fastest, 100.0 * slip);
  }
}

}  // namespace
}  // namespace gasgrain::stability
