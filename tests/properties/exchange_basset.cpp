// The memory of the Basset force against exact integrals and solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "coupling/exchange/forces/basset.h"
#include "coupling/exchange/forces/virtual_mass.h"

namespace gasgrain {
namespace {

const GasProperties air{1.2, 1.8e-5};
const GasProperties unit_gas{1.0, 1.0};

// Mean over step n of Int_0^t (t - s)^(-1/2) ds = 2 t^(1/2).
TEST(basset, of_a_constant_rate_grows_as_the_root_of_time_over_1e5_steps) {
  const double dt = 1e-5;
  const double root_dt = std::sqrt(dt);
  const BassetKernel memory(dt, 1.0, 0.01);
  EXPECT_EQ(memory.terms(), 9U);
  std::vector<double> state(memory.state_size(), 0.0);
  const double radius = 1e-3;
  const double B = ForceBasset::coefficient(air, radius);
  for (int n = 0; n <= 100000; ++n) {
    const Vec3 force =
        memory.added_mass(air, radius) * Vec3::UnitX() + memory.history(air, radius, state.data());
    const double t = n;
    const double mean = 4.0 / 3.0 * root_dt * (std::pow(t + 1.0, 1.5) - std::pow(t, 1.5));
    ASSERT_NEAR(force.x() / (B * mean), 1.0, memory.error()) << "step " << n;
    memory.advance(state.data(), Vec3::UnitX());
  }
}

// Int_0^inf cos(w (t - s)) s^(-1/2) ds = (pi / w)^(1/2) cos(w t - pi/4). What the beginning leaves
// behind is 1 / (pi w t)^(1/2) of it, 1 % after 500 periods.
TEST(basset, of_an_oscillation_lags_by_an_eighth_of_a_period) {
  const double w = 2.0 * pi;
  const int steps_a_period = 100;
  const int steps = 500 * steps_a_period;
  const double dt = 1.0 / steps_a_period;
  const BassetKernel memory(dt, steps * dt, 0.01);
  std::vector<double> state(memory.state_size(), 0.0);
  const double B = ForceBasset::coefficient(unit_gas, 1.0);
  for (int n = 0; n < steps; ++n) {
    const double t = (n + 0.5) * dt;
    const Vec3 rate = std::cos(w * t) * Vec3::UnitX();
    const Vec3 force =
        memory.added_mass(unit_gas, 1.0) * rate + memory.history(unit_gas, 1.0, state.data());
    memory.advance(state.data(), rate);
    if (n < steps - steps_a_period) continue;
    EXPECT_NEAR(force.x() / (B * std::sqrt(pi / w)), std::cos(w * t - 0.25 * pi), 0.02) << t;
  }
}

// One step of acceleration, and how its force fades.
TEST(basset, meets_its_tolerance_at_every_step_up_to_the_horizon_and_fades_beyond) {
  const int horizon = 10000;
  for (const double tolerance : {0.1, 0.05, 0.01, 0.001, 0.0001}) {
    const BassetKernel memory(1.0, horizon, tolerance);
    EXPECT_LE(memory.error(), tolerance);
    std::vector<double> state(memory.state_size(), 0.0);
    memory.advance(state.data(), Vec3::UnitY());
    const double B = ForceBasset::coefficient(unit_gas, 1.0);
    double last = std::numeric_limits<double>::infinity();
    for (int m = 1; m <= 30 * horizon; ++m) {
      const double kernel = memory.history(unit_gas, 1.0, state.data()).y() / B;
      const double n = m;
      const double exact =
          m < 100 ? 4.0 / 3.0 *
                        (std::pow(n + 1.0, 1.5) - 2.0 * std::pow(n, 1.5) + std::pow(n - 1.0, 1.5))
                  : 1.0 / std::sqrt(n);
      // The series of g_m, cut off at 1 / sqrt(m), is right to 1/16 m^-2.
      if (m <= horizon) {
        ASSERT_NEAR(kernel / exact, 1.0, tolerance + 1e-5) << "step " << m;
      }
      ASSERT_LT(kernel, last);
      ASSERT_GT(kernel, 0.0);
      last = kernel;
      memory.advance(state.data(), Vec3::Zero());
    }
    EXPECT_LT(last, 0.05 / std::sqrt(30.0 * horizon));
  }
}

TEST(basset, refuses_a_step_a_horizon_or_a_tolerance_it_cannot_work_with) {
  EXPECT_ANY_THROW(BassetKernel(0.0, 1.0, 0.01));
  EXPECT_ANY_THROW(BassetKernel(1.0, 5.0, 0.01));
  EXPECT_ANY_THROW(BassetKernel(1.0, 100.0, 1e-7));
}

// A sphere of 0.3 of the fluid's density, let go in creeping flow: with virtual mass and Basset's
// force A v' + B Int v' (t - s)^(-1/2) ds + D v = D has the solution below (Laplace), p and q being
// the roots of A r^2 - B pi^(1/2) r + D.
struct FreeSphere {
  double radius = 1.0;
  double mass = 0.3 * sphere_volume(1.0);
  double A = mass + ForceVirtualMass::added_mass(unit_gas, 1.0);
  double B = ForceBasset::coefficient(unit_gas, 1.0);
  double D = stokes_coefficient(unit_gas, 2.0);

  [[nodiscard]] double exact(double t) const {
    const double sum = B * std::sqrt(pi) / A;
    const double root = std::sqrt(sum * sum - 4.0 * D / A);
    const double p = 0.5 * (sum + root);
    const double q = 0.5 * (sum - root);
    const auto decay = [&](double r) { return std::exp(r * r * t) * std::erfc(r * std::sqrt(t)); };
    return 1.0 + (q * decay(p) - p * decay(q)) / (p - q);
  }

  // Drag at the middle of the step; `history`: with Basset's force.
  [[nodiscard]] double velocity(double t, int steps, double tolerance, bool history = true) const {
    const double dt = t / steps;
    const BassetKernel memory(dt, t, tolerance);
    std::vector<double> state(memory.state_size(), 0.0);
    const double inertia = A + 0.5 * dt * D + (history ? memory.added_mass(unit_gas, radius) : 0.0);
    double v = 0.0;
    for (int n = 0; n < steps; ++n) {
      const double of_past = history ? memory.history(unit_gas, radius, state.data()).z() : 0.0;
      const double a = (D * (1.0 - v) + of_past) / inertia;
      memory.advance(state.data(), Vec3(0.0, 0.0, -a));
      v += a * dt;
    }
    return v;
  }
};

TEST(basset, lets_a_free_sphere_fall_as_the_exact_solution_does) {
  const FreeSphere sphere;
  for (const double t : {0.01, 0.1, 1.0})
    for (const double tolerance : {0.1, 0.05, 0.01, 0.001}) {
      // The error of g_m changes its sign from term to term, so that most of it cancels.
      EXPECT_NEAR(sphere.velocity(t, 1000, tolerance) / sphere.exact(t), 1.0, 0.02 * tolerance)
          << "t " << t << ", tolerance " << tolerance;
    }
  // Without the force it is this much too fast.
  EXPECT_NEAR(sphere.velocity(1.0, 1000, 0.01, false) / sphere.exact(1.0), 1.833, 1e-3);
}

TEST(basset, converges_with_the_square_of_the_step) {
  const FreeSphere sphere;
  const double t = 1.0;
  std::vector<double> errors;
  for (const int steps : {10, 20, 40, 80})
    errors.push_back(std::abs(sphere.velocity(t, steps, 1e-4) - sphere.exact(t)));
  for (std::size_t n = 1; n < errors.size(); ++n)
    EXPECT_NEAR(std::log2(errors[n - 1] / errors[n]), 2.0, 0.1) << errors[n];
}

}  // namespace
}  // namespace gasgrain
