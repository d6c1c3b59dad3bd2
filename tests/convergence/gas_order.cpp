// Orders of convergence in space and time.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr double side = 1.0;
constexpr double viscosity = 0.01;
constexpr double density = 1.0;
const double wave = 2 * M_PI / side;
constexpr double drift = 0.5;  // the vortices move, so that no symmetry cancels errors

// Taylor-Green vortices carried by a uniform flow.
double exact(int component, double x, double z, double t) {
  const double decay = std::exp(-2 * viscosity / density * wave * wave * t);
  const double a = wave * (x - drift * t);
  const double b = wave * (z - drift * t);
  return drift + decay * (component == 0 ? std::sin(a) * std::cos(b) : -std::cos(a) * std::sin(b));
}

GasInput vortices(int cells, Convection convection) {
  Sides sides;
  sides.fill(&periodic_side);
  GasInput input = box({cells, 1, cells}, Vec3(side, side / cells, side), sides);
  input.gravity = Vec3::Zero();
  input.density = density;
  input.viscosity = viscosity;
  input.convection = convection;
  input.tolerance = 1e-10;
  input.courant_max = 1000;
  input.step = 1;
  return input;
}

void start(GasSolver& gas, int cells) {
  const double h = side / cells;
  for (const int d : {0, 2})
    for_each_cell(gas.domain().box(), [&](int i, int j, int k) {
      const double x = (i + (d == 0 ? 0.0 : 0.5)) * h;
      const double z = (k + (d == 2 ? 0.0 : 0.5)) * h;
      gas.state().velocity[d](i, j, k) = exact(d, x, z, 0);
    });
  set_bed(
      gas, [](int, int, int) { return 1.0; }, constant_zero, constant_zero);
}

// Mean over the faces of |u - exact|.
double error(int cells, Convection convection, int steps, double end) {
  GasSolver gas(vortices(cells, convection), self());
  start(gas, cells);
  for (int n = 0; n < steps; ++n) gas.advance(end / steps);
  const double h = side / cells;
  double sum = 0;
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    sum += std::abs(gas.state().velocity[0](i, j, k) - exact(0, i * h, (k + 0.5) * h, end));
  });
  return sum / (cells * cells);
}

TEST(gas_order, tvd_convection_is_of_second_order_in_the_mean) {
  // The limiter falls back to first order at extrema, hence the mean of errors and a bound below 2.
  // The number of steps grows fourfold, so that the error in time falls as fast.
  const double coarse = error(32, Convection::tvd, 100, 0.1);
  const double fine = error(64, Convection::tvd, 400, 0.1);
  const double order = std::log2(coarse / fine);
  RecordProperty("order", std::to_string(order));
  std::printf("order %.3f  (%.3e, %.3e)\n", order, coarse, fine);
  EXPECT_GT(order, 1.9);
}

TEST(gas_order, upwind_convection_is_of_first_order) {
  const double coarse = error(48, Convection::upwind, 200, 0.1);
  const double fine = error(96, Convection::upwind, 400, 0.1);
  const double order = std::log2(coarse / fine);
  std::printf("order %.3f  (%.3e, %.3e)\n", order, coarse, fine);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(order, 1.3);
}

TEST(gas_order, implicit_euler_is_of_first_order_in_time) {
  // Against a solution with many steps on the same grid, so that the error in space drops out.
  const int cells = 24;
  const auto solution = [&](int steps) {
    GasSolver gas(vortices(cells, Convection::upwind), self());
    start(gas, cells);
    for (int n = 0; n < steps; ++n) gas.advance(0.2 / steps);
    return gas.state().velocity[0];
  };
  const Array3<double> reference = solution(1280);
  const auto error_of = [&](int steps) {
    const Array3<double> u = solution(steps);
    double sum = 0;
    for (std::size_t n = 0; n < u.size(); ++n) sum += std::abs(u[n] - reference[n]);
    return sum;
  };
  const double order = std::log2(error_of(20) / error_of(40));
  std::printf("order %.3f\n", order);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(order, 1.2);
}

}  // namespace
}  // namespace gasgrain
