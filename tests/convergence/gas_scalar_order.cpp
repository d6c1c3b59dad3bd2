// Orders of the scalar transport: convection and diffusion of a wave round a periodic axis.
#include <gtest/gtest.h>

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/scalars/scalar_equation.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr double conductance = 0.01;
constexpr double wave = 2 * M_PI;

// A ring of n cells of length 1 along z, mass 1, mass flux 1.
struct Ring {
  explicit Ring(int n, bool limited)
      : domain(grid(n), self()),
        halo(domain),
        equation(domain, halo, {limited, false, 1e-12}),
        terms(domain.box()),
        phi(domain.box()) {
    for (Array3<double>& f : flux) f = Array3<double>(domain.box());
    flux[2].fill(1.0);
    terms.mass.fill(1.0);
    terms.conductance.fill(conductance);
  }
  static BoxGrid grid(int n) {
    BoxGrid grid;
    grid.hi = Vec3(0.1, 0.1, 1);
    grid.cells = {1, 1, n};
    grid.periodic = {true, true, true};
    return grid;
  }
  void set(const std::function<double(double z)>& value) {
    for_each_cell(domain.own(), [&](int i, int j, int k) { phi(i, j, k) = value(z(k)); });
    halo.exchange({&phi});
  }
  [[nodiscard]] double z(int k) const { return (k + 0.5) / domain.grid().cells[2]; }
  void step(double dt) {
    equation.assemble(terms, flux, dt, phi, {});
    equation.solve(phi);
  }
  Domain domain;
  Halo halo;
  ScalarEquation equation;
  ScalarTerms terms;
  std::array<Array3<double>, 3> flux;
  Array3<double> phi;
};

// Mean |error| of the steady field 2 + sin(w z) that a source keeps up.
double steady_error(int n, bool limited) {
  Ring ring(n, limited);
  const auto exact = [](double z) { return 2 + std::sin(wave * z); };
  ring.terms.sink.fill(1.0);
  for_each_cell(ring.domain.own(), [&](int i, int j, int k) {
    const double z = ring.z(k);
    ring.terms.source(i, j, k) =
        wave * std::cos(wave * z) + conductance * wave * wave * std::sin(wave * z) + exact(z);
  });
  ring.set(exact);
  for (int s = 0; s < 20 * n; ++s) ring.step(0.5 / n);
  double error = 0;
  for (int k = 0; k < n; ++k) error += std::abs(ring.phi(0, 0, k) - exact(ring.z(k))) / n;
  return error;
}

TEST(gas_scalar_order, upwind_is_of_first_order_in_space) {
  const double order = std::log2(steady_error(48, false) / steady_error(96, false));
  EXPECT_GT(order, 0.9);
  EXPECT_LT(order, 1.1);
}

TEST(gas_scalar_order, limited_is_of_second_order_in_space) {
  // At its two extrema the limiter falls back to upwind: the mean of |error| keeps the order, the
  // greatest does not.
  const double order = std::log2(steady_error(32, true) / steady_error(64, true));
  EXPECT_GT(order, 1.7);
}

TEST(gas_scalar_order, implicit_euler_is_of_first_order_in_time) {
  const auto at_end = [](int steps) {
    Ring ring(64, false);
    ring.set([](double z) { return 2 + std::sin(wave * z); });
    for (int s = 0; s < steps; ++s) ring.step(0.5 / steps);
    return ring.phi;
  };
  const Array3<double> coarse = at_end(50);
  const Array3<double> middle = at_end(100);
  const Array3<double> fine = at_end(200);
  double first = 0;
  double second = 0;
  for (int k = 0; k < 64; ++k) {
    first += std::abs(coarse(0, 0, k) - middle(0, 0, k));
    second += std::abs(middle(0, 0, k) - fine(0, 0, k));
  }
  const double order = std::log2(first / second);
  EXPECT_NEAR(order, 1.0, 0.15);
}

TEST(gas_scalar_order, wave_decays_and_travels_as_the_exact_one) {
  Ring ring(128, true);
  ring.set([](double z) { return 2 + std::sin(wave * z); });
  const double time = 0.25;
  for (int s = 0; s < 500; ++s) ring.step(time / 500);
  const double amplitude = std::exp(-conductance * wave * wave * time);
  double error = 0;
  for (int k = 0; k < 128; ++k)
    error +=
        std::abs(ring.phi(0, 0, k) - 2 - amplitude * std::sin(wave * (ring.z(k) - time))) / 128;
  // Implicit Euler diffuses by u^2 dt / 2 = 2.5e-4, 2.5 % of the conductance: 0.25 % of the wave.
  EXPECT_LT(error, 4e-3);
}

}  // namespace
}  // namespace gasgrain
