// Orders of convergence in space and time on Taylor-Green vortices that a uniform flow carries
// along.
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

double exact(int component, double x, double z, double t) {
  const double decay = std::exp(-2 * viscosity / density * wave * wave * t);
  const double a = wave * (x - drift * t);
  const double b = wave * (z - drift * t);
  return drift + decay * (component == 0 ? std::sin(a) * std::cos(b) : -std::cos(a) * std::sin(b));
}

GasInput vortices(int cells, Convection convection, TimeScheme scheme) {
  Sides sides;
  sides.fill(&periodic_side);
  GasInput input = box({cells, 1, cells}, Vec3(side, side / cells, side), sides);
  input.gravity = Vec3::Zero();
  input.density = density;
  input.viscosity = viscosity;
  input.convection = convection;
  input.scheme = scheme;
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
double error(int cells, Convection convection, TimeScheme scheme, int steps, double end) {
  GasSolver gas(vortices(cells, convection, scheme), self());
  start(gas, cells);
  for (int n = 0; n < steps; ++n) gas.advance(end / steps);
  const double h = side / cells;
  double sum = 0;
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    sum += std::abs(gas.state().velocity[0](i, j, k) - exact(0, i * h, (k + 0.5) * h, end));
  });
  return sum / (cells * cells);
}

double order(const char* what, double coarse, double fine) {
  const double value = std::log2(coarse / fine);
  std::printf("%-44s order %.3f  (%.3e, %.3e)\n", what, value, coarse, fine);
  return value;
}

double order_in_space(const char* what, Convection convection, int cells) {
  // Of second order in time with steps that shrink as the cells do: the Courant number is 0.3.
  const auto run = [&](int n) {
    return error(n, convection, TimeScheme::crank_nicolson, n / 2, 0.1);
  };
  return order(what, run(cells), run(2 * cells));
}

TEST(gas_order, central_and_quick_convection_are_of_second_order) {
  EXPECT_GT(order_in_space("central", Convection::central, 32), 1.9);
  EXPECT_GT(order_in_space("quick", Convection::quick, 32), 1.9);
}

TEST(gas_order, tvd_convection_is_of_second_order_in_the_mean) {
  // The limiter falls back to first order at extrema, hence the mean of errors.
  EXPECT_GT(order_in_space("tvd", Convection::tvd, 32), 1.9);
}

TEST(gas_order, upwind_convection_is_of_first_order) {
  const double value = order_in_space("upwind", Convection::upwind, 64);
  EXPECT_GT(value, 0.9);
  EXPECT_LT(value, 1.2);
}

TEST(gas_order, blended_convection_has_the_share_of_the_error_of_upwind) {
  // At the default share of 1/2.
  const double upwind = error(64, Convection::upwind, TimeScheme::crank_nicolson, 32, 0.1);
  const double blend = error(64, Convection::blend, TimeScheme::crank_nicolson, 32, 0.1);
  std::printf("error of blend over that of upwind %.3f\n", blend / upwind);
  EXPECT_NEAR(blend / upwind, 0.5, 0.05);
}

// Against a solution with many steps on the same grid, so that the error in space drops out.
double order_in_time(const char* what, Convection convection, TimeScheme scheme, int steps,
                     int reference_steps) {
  const int cells = 24;
  const double end = 0.2;
  const auto solution = [&](int n_steps) {
    GasSolver gas(vortices(cells, convection, scheme), self());
    start(gas, cells);
    for (int n = 0; n < n_steps; ++n) gas.advance(end / n_steps);
    return gas.state().velocity[0];
  };
  const Array3<double> reference = solution(reference_steps);
  const auto error_of = [&](int n_steps) {
    const Array3<double> u = solution(n_steps);
    double sum = 0;
    for (std::size_t n = 0; n < u.size(); ++n) sum += std::abs(u[n] - reference[n]);
    return sum;
  };
  return order(what, error_of(steps), error_of(2 * steps));
}

TEST(gas_order, implicit_euler_is_of_first_order_in_time) {
  const double value = order_in_time("implicit Euler, upwind", Convection::upwind,
                                     TimeScheme::implicit_euler, 20, 1280);
  EXPECT_GT(value, 0.95);
  EXPECT_LT(value, 1.2);
}

TEST(gas_order, crank_nicolson_is_of_second_order_in_time) {
  EXPECT_GT(order_in_time("Crank-Nicolson, upwind", Convection::upwind, TimeScheme::crank_nicolson,
                          20, 640),
            1.9);
  EXPECT_GT(order_in_time("Crank-Nicolson, central", Convection::central,
                          TimeScheme::crank_nicolson, 20, 640),
            1.9);
}

}  // namespace
}  // namespace gasgrain
