// Drag whose relaxation time is 1e-3, 1 and 1e3 of the step (of the coupling interval T).
//
// A cloud of grains and gas in a periodic box have nothing but each other. a = T / tau, tau = m /
// K; L: mass of the grains over that of the gas. Whatever a and L, they come together at the
// velocity that their momentum gives, and nothing is ever faster than the fastest was at first.
#include <gtest/gtest.h>

#include "tests/stability/periodic_cloud.h"

namespace gasgrain::stability {
namespace {

constexpr const char* effects = PeriodicCloud::effects;

const std::vector<Stiffness> hard_cases{{1e-3, 1.0},  {1e-3, 100.0}, {1.0, 1.0},
                                        {1.0, 100.0}, {1e3, 1.0},    {1e3, 100.0}};

std::string text_of(const Stiffness& s, bool overlapped) {
  return "a = " + std::to_string(s.interval_over_relaxation) +
         ", L = " + std::to_string(s.loading) + (overlapped ? ", overlapped" : ", in turn");
}

TEST(drag_stiffness, a_scattered_cloud_gains_no_energy_and_no_speed_whatever_the_relaxation_time) {
  for (const Stiffness& stiffness : hard_cases)
    for (const bool overlapped : {false, true}) {
      SCOPED_TRACE(text_of(stiffness, overlapped));
      PeriodicCloud scene(stiffness, 1.0);
      scene.pace.overlapped = overlapped;
      CoupledBed bed(scene.input, effects, scene.pace, scene.cloud);
      const double energy = bed.grain_energy();
      const double speed = bed.fastest_grain();
      for (int n = 0; n < 200; ++n) {
        bed.advance();
        // The carry keeps the balance of each grain, not its energy: round-off of the solver's
        // tolerance times a L is all that may be added.
        ASSERT_LE(bed.grain_energy(), energy * (1 + 1e-6)) << n;
        ASSERT_LE(gas_cases::greatest_speed(bed.gas()), speed * (1 + 1e-6)) << n;
        ASSERT_LE(bed.fastest_grain(), speed * (1 + 1e-6)) << n;
        ASSERT_GT(least_void_fraction(bed.gas()), 0.85) << n;
      }
      EXPECT_LT(bed.ledger().residual(), 1e-10);
    }
}

// Of an even cloud the momentum of the gas is known to round-off, and the way of the slip exactly:
// exp(-(1 + L) t / tau).
TEST(drag_stiffness, an_even_cloud_keeps_the_momentum_of_both_and_relaxes_as_the_exact_solution) {
  for (const Stiffness& stiffness : hard_cases) {
    SCOPED_TRACE(text_of(stiffness, false));
    const double a = stiffness.interval_over_relaxation;
    const double L = stiffness.loading;
    PeriodicCloud scene(stiffness, 0.0);
    CoupledBed bed(scene.input, effects, scene.pace, scene.cloud);
    const double before = bed.grain_momentum()[0];
    const double grains = static_cast<double>(bed.cloud.radius.size());
    const double gas_mass = grains * bed.cloud.mass[0] / L;
    const int couplings = 300;
    double slip = scene.mean_speed;
    for (int n = 1; n <= couplings; ++n) {
      bed.advance();
      const double of_gas = gas_momentum(bed.gas(), scene.input.density)[0];
      const double owed = outstanding_carry(bed.cloud.view(), bed.records())[0];
      // An impulse of K T u is known to the tolerance of u: a L of the gas's own momentum.
      ASSERT_NEAR(of_gas + bed.grain_momentum()[0] - owed, before,
                  (1e-10 + 1e-11 * a * L) * before * n)
          << n;
      slip = bed.cloud.velocity[0] - of_gas / gas_mass;
      ASSERT_LE(std::abs(slip), scene.mean_speed * (1 + 1e-9)) << n;
      if (a * (1 + L) > 0.2) continue;
      // First order in the interval: of each relaxation time the part a (1 + L) / 2.
      const double passed = n * a * (1 + L);
      ASSERT_NEAR(slip / scene.mean_speed, std::exp(-passed), 0.6 * a * (1 + L)) << n;
    }
    if (a == 1.0) {
      EXPECT_NEAR(bed.cloud.velocity[0], scene.common, 1e-6 * scene.common);
    }
    EXPECT_LT(std::abs(slip), scene.mean_speed * (a < 1 && L == 1.0 ? 0.6 : 1e-2));
  }
}

TEST(drag_stiffness, explicit_drag_breaks_the_same_bound) {
  for (const Stiffness& stiffness : hard_cases) {
    const double growth = stiffness.interval_over_relaxation * (1 + stiffness.loading);
    PeriodicCloud scene(stiffness, 1.0);
    ExplicitBed bed(scene.input, effects, scene.pace.interval, scene.cloud);
    const double speed = bed.fastest_grain();
    double fastest = 0.0;
    for (int n = 0; n < 6 && fastest < 1e6 * speed; ++n) {
      bed.advance();
      fastest = std::max({fastest, bed.fastest_grain(), gas_cases::greatest_speed(bed.gas())});
    }
    SCOPED_TRACE(text_of(stiffness, false));
    std::printf("explicit drag, a (1 + L) = %g: fastest %.3g of the first\n", growth,
                fastest / speed);
    if (growth > 10.0) {
      EXPECT_GT(fastest, 1e3 * speed);
    } else if (growth < 1.0) {
      EXPECT_LE(fastest, speed * (1 + 1e-6));
    }
  }
}

// Nothing but round-off moves at first.
TEST(drag_stiffness, at_rest_nothing_grows_out_of_round_off_but_with_explicit_drag_it_does) {
  constexpr double round_off = 1e-16;
  PeriodicCloud scene({10.0, 1.0}, 1.0);
  for (double& v : scene.cloud.velocity) v *= round_off / scene.mean_speed;
  CoupledBed ours(scene.input, effects, scene.pace, scene.cloud);
  ExplicitBed naive(scene.input, effects, scene.pace.interval, scene.cloud);
  const double speed = ours.fastest_grain();
  for (int n = 0; n < 1000; ++n) {
    ours.advance();
    ASSERT_LE(ours.fastest_grain(), speed * (1 + 1e-6)) << n;
  }
  for (int n = 0; n < 12; ++n) naive.advance();
  std::printf("out of %g m/s: %.2g m/s after 1000 steps, with explicit drag %.2g m/s after 12\n",
              round_off, ours.fastest_grain(), naive.fastest_grain());
  EXPECT_GT(naive.fastest_grain(), 1e9 * speed);
}

}  // namespace
}  // namespace gasgrain::stability
