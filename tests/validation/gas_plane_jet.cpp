// A turbulent plane jet into gas at rest: the spreading rate of the standard k-epsilon model.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr double slot = 0.02;  // whole width b; half of it lies in the domain [m]
constexpr double velocity = 20;

// Velocity on the axis, a plane of symmetry half a cell from the first cell's centre.
double on_axis(const GasSolver& gas, int k) {
  const Array3<double>& w = gas.state().velocity[2];
  return w(0, 0, k) + (w(0, 0, k) - w(1, 0, k)) / 8;
}

// Distance from the axis where the velocity is half of that on it.
double half_width(const GasSolver& gas, int k) {
  const Array3<double>& w = gas.state().velocity[2];
  const double half = 0.5 * on_axis(gas, k);
  int i = 1;
  while (i + 1 < gas.grid().cells[0] && w(i, 0, k) > half) ++i;
  const double part = (w(i - 1, 0, k) - half) / (w(i - 1, 0, k) - w(i, 0, k));
  return gas.grid().spacing()[0] * (i - 0.5 + part);
}

TEST(gas_plane_jet, spreads_and_decays_as_plane_jets_do_also_while_it_starts) {
  const Sides sides{&wall_free_slip, &outlet,         &periodic_side,
                    &periodic_side,  &wall_free_slip, &outlet};
  GasInput input = box({60, 1, 60}, Vec3(0.6, 0.01, 1.2), sides);
  input.gravity = Vec3::Zero();
  input.step = 4e-3;  // Courant number 8
  input.turbulence.model = TurbulenceModel::k_epsilon;
  InflowPatch jet;
  jet.side = 4;
  jet.outline.bounds = {{0.0, 0.0}, {0.5 * slot, 0.01}};
  jet.velocity = velocity;
  input.inflows = {jet};
  GasSolver gas(input, self());
  for (int n = 0; n < 300; ++n) {
    const GasReport report = gas.advance(input.step);
    ASSERT_EQ(report.turbulence_clamped, 0) << n;
    ASSERT_EQ(report.turbulence_not_converged, 0) << n;
  }
  // Over 25 to 50 slots from the nozzle; faces k lie a slot apart.
  const double rate = (half_width(gas, 50) - half_width(gas, 25)) / (25 * slot);
  std::printf("spreading rate %.4f\n", rate);
  // Measured 0.100 to 0.110; the model's self-similar jet 0.109 (D. C. Wilcox, Turbulence Modeling
  // for CFD, chapter 4). Twice the cells along each axis give 0.1075.
  EXPECT_NEAR(rate, 0.109, 0.003);
  for (const int k : {20, 30, 40, 50}) {
    const double decay = on_axis(gas, k) / velocity * std::sqrt(k);
    std::printf("%d b: U/U_0 sqrt(z/b) = %.3f\n", k, decay);
    // Constant along the jet; measured 2.47, to a few per cent (N. Rajaratnam, Turbulent Jets,
    // 1976: 3.50 with half of the slot).
    EXPECT_NEAR(decay, 2.47, 0.05 * 2.47);
  }
}

}  // namespace
}  // namespace gasgrain
