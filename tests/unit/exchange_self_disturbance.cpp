// The answer of the gas to a particle's own drag, against the integrals and sums it stands for.
#include "coupling/exchange/self_disturbance.h"

#include <gtest/gtest.h>

namespace gasgrain {
namespace {

constexpr GasProperties gas{1.2, 1.8e-5};

// 3/2 times the integral over c = 0..1 of (1 - c^2) (1 - pi^1/2 a exp(a^2) erfc(a)), a = c s: R
// over that of Stokes, from the integral of |w|^2 (1 - c^2) k^2 / (mu k^4 + ...) over all wave
// vectors.
double oseen_over_stokes(double s) {
  const int steps = 20000;
  double sum = 0.0;
  for (int n = 0; n < steps; ++n) {
    const double c = (n + 0.5) / steps;
    const double a = c * s;
    // The continued fraction of exp(a^2) erfc(a) where the product would overflow.
    const double scaled = a < 5.0 ? std::sqrt(pi) * a * std::exp(a * a) * std::erfc(a)
                                  : 1.0 - 1.0 / (2.0 * a * a) + 3.0 / (4.0 * std::pow(a, 4));
    sum += (1.0 - c * c) * (1.0 - scaled) / steps;
  }
  return 1.5 * sum;
}

TEST(self_disturbance, is_oseens_for_a_bell_much_wider_than_cells) {
  const double sigma = 1.0;
  const Footprint wide{Vec3::Constant(sigma * sigma), Vec3::Constant(1e-6)};
  const double stokes = 1.0 / (6.0 * std::pow(pi, 1.5) * gas.viscosity * sigma);
  for (const double s : {1e-6, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0, 1000.0}) {
    const double speed = s * gas.viscosity / (gas.density * sigma);
    const double R = disturbance_per_force(gas, wide, Vec3(0.0, 0.0, speed));
    EXPECT_NEAR(R / stokes / oseen_over_stokes(s), 1.0, 0.06) << s;
  }
}

TEST(self_disturbance, is_that_of_the_discrete_laplacian_for_a_particle_in_one_cell) {
  // Green's function of the simple cubic lattice at its origin, 0.252731 (Watson 1939); two thirds
  // of it are left by the pressure. The mean over faces is beside it and set to nothing here.
  const double h = 1.0;
  const double bell = h * h / 32.0;
  const double R = 1.0 / (6.0 * std::pow(pi, 1.5) * std::sqrt(bell));
  EXPECT_NEAR(R / (2.0 / 3.0 * 0.252731 / h), 1.0, 0.01);
}

TEST(self_disturbance, falls_with_slip_and_width_and_knows_no_axis) {
  const Footprint cell{Vec3::Constant(0.1), Vec3::Ones()};
  EXPECT_GT(disturbance_per_force(gas, cell, Vec3(1e-6, 0, 0)),
            disturbance_per_force(gas, cell, Vec3(1e-3, 0, 0)));
  EXPECT_GT(disturbance_per_force(gas, cell, Vec3(1e-3, 0, 0)),
            disturbance_per_force(gas, {Vec3::Constant(0.4), Vec3::Ones()}, Vec3(1e-3, 0, 0)));
  const double x = disturbance_per_force(gas, cell, Vec3(1e-3, 0, 0));
  EXPECT_DOUBLE_EQ(x, disturbance_per_force(gas, cell, Vec3(0, 0, -1e-3)));
  EXPECT_NEAR(x, disturbance_per_force(gas, cell, Vec3(1e-3, 1e-3, 1e-3) / std::sqrt(3.0)),
              1e-12 * x);
  EXPECT_TRUE(std::isfinite(disturbance_per_force(gas, cell, Vec3::Zero())));
}

TEST(self_disturbance, a_particle_sees_the_solids_it_gave) {
  // One cell: all of it. Two halves: half of it. Eight eighths: an eighth.
  const Vec3 h = Vec3::Ones();
  EXPECT_NEAR(own_solid_fraction(1.0, {Vec3::Zero(), h}), 1.0, 0.1);
  EXPECT_NEAR(own_solid_fraction(1.0, {Vec3(0.25, 0.0, 0.0), h}), 0.5, 0.05);
  EXPECT_NEAR(own_solid_fraction(1.0, {Vec3::Constant(0.25), h}), 0.125, 0.02);
  EXPECT_EQ(alone(0.0), 1.0);
  EXPECT_EQ(alone(solids_of_neighbours), 0.5);
  EXPECT_LT(alone(0.4), 1e-3);
}

}  // namespace
}  // namespace gasgrain
