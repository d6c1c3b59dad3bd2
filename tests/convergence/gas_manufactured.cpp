// Orders of convergence on a manufactured solution with void fraction that varies in space and
// time, implicit drag and the full stress tensor: the volume-averaged equations as a whole.
//
// Fluxes eps u are chosen such that d eps/dt + div(eps u) = 0, the force that makes them a solution
// follows from the momentum equation, whose derivatives are taken numerically, to 1e-9.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

constexpr double k = 2 * M_PI;  // one wave in a box of 1 m
constexpr double viscosity = 0.02;
constexpr double pressure_amplitude = 2.0;

struct Problem {
  bool with_y = false;     // three dimensions, else x and z
  double growth = 0;       // of eps in time [1/s]
  double oscillation = 0;  // of the flow in time
  GasModel model = GasModel::a;

  [[nodiscard]] double cos_y(const Vec3& x) const { return with_y ? std::cos(k * x[1]) : 1.0; }

  [[nodiscard]] double eps(const Vec3& x, double t) const {
    return 0.6 + 0.2 * std::sin(k * x[0] + 0.3) * cos_y(x) * std::cos(k * x[2]) +
           growth * t * std::cos(k * x[0]) * std::cos(k * x[2]);
  }
  [[nodiscard]] double flux(int d, const Vec3& x, double t) const {
    const double amplitude = 0.5 * (1 + oscillation * std::sin(5 * t));
    const double sx = std::sin(k * x[0]), cx = std::cos(k * x[0]);
    const double sz = std::sin(k * x[2]), cz = std::cos(k * x[2]);
    const double displaced = -growth / (2 * k);
    if (d == 1) return with_y ? amplitude * cx * std::sin(k * x[1]) * cz : 0.0;
    if (d == 0) return 0.3 + amplitude * sx * cos_y(x) * cz + displaced * sx * cz;
    return 0.4 - amplitude * (with_y ? 2 : 1) * cx * cos_y(x) * sz + displaced * cx * sz;
  }
  [[nodiscard]] double u(int d, const Vec3& x, double t) const { return flux(d, x, t) / eps(x, t); }
  [[nodiscard]] static double p(const Vec3& x) {
    return pressure_amplitude * std::sin(k * x[0]) * std::sin(k * x[2] + 1);
  }
  [[nodiscard]] static double drag(const Vec3& x) { return 5 + 3 * std::cos(k * x[0]); }

  // d f / d x_axis, of sixth order.
  template <class F>
  static double derivative(F&& f, Vec3 x, int axis) {
    constexpr double h = 4e-3;
    const auto at = [&](int n) {
      Vec3 y = x;
      y[axis] += n * h;
      return f(y);
    };
    return (45 * (at(1) - at(-1)) - 9 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60 * h);
  }

  [[nodiscard]] double stress(int i, int j, const Vec3& x, double t) const {
    double sum = derivative([&](const Vec3& y) { return u(i, y, t); }, x, j) +
                 derivative([&](const Vec3& y) { return u(j, y, t); }, x, i);
    if (i == j)
      for (int d = 0; d < 3; ++d)
        sum -= 2.0 / 3.0 * derivative([&](const Vec3& y) { return u(d, y, t); }, x, d);
    return eps(x, t) * viscosity * sum;
  }

  // The force S, at density 1.
  [[nodiscard]] double source(int d, const Vec3& x, double t) const {
    constexpr double h = 1e-4;
    double force = eps(x, t) * (u(d, x, t + h) - u(d, x, t - h)) / (2 * h);
    force += drag(x) * u(d, x, t) + (model == GasModel::a ? eps(x, t) : 1.0) * derivative(p, x, d);
    for (int e = 0; e < 3; ++e) {
      force += flux(e, x, t) * derivative([&](const Vec3& y) { return u(d, y, t); }, x, e);
      force -= derivative([&](const Vec3& y) { return stress(d, e, y, t); }, x, e);
    }
    return force;
  }
};

struct Errors {
  double velocity = 0;  // means over the grid
  double pressure = 0;
};

struct Scheme {
  Convection convection = Convection::central;
  TimeScheme scheme = TimeScheme::implicit_euler;
  PressureVelocity method = PressureVelocity::projection;
  int cells = 16;
  int steps = 100;
  double end = 1;
};

struct Solution {
  CellVector velocity;
  Array3<double> pressure;
  Errors error;
};

Solution solve(const Problem& problem, const Scheme& run) {
  Sides sides;
  sides.fill(&periodic_side);
  const int n = run.cells;
  GasInput input =
      box({n, problem.with_y ? n : 1, n}, Vec3(1, problem.with_y ? 1.0 : 1.0 / n, 1), sides);
  input.gravity = Vec3::Zero();
  input.density = 1;
  input.viscosity = viscosity;
  input.convection = run.convection;
  input.scheme = run.scheme;
  input.pressure_velocity = run.method;
  const bool simple = run.method == PressureVelocity::simple;
  input.relax_velocity = simple ? 0.7 : 0.9;
  input.relax_pressure = simple ? 0.3 : 1.0;
  input.outer_tolerance = 1e-7;
  input.model = problem.model;
  input.tolerance = 1e-9;
  input.courant_max = 1000;
  input.step = 1e3;
  GasSolver gas(input, self());
  const Vec3 h = gas.grid().spacing();
  const auto center = [&](int i, int j, int m) -> Vec3 {
    return h.cwiseProduct(Vec3(i + 0.5, j + 0.5, m + 0.5));
  };
  const auto face = [&](int d, int i, int j, int m) {
    Vec3 x = center(i, j, m);
    x[d] -= 0.5 * h[d];
    return x;
  };
  for (int d = 0; d < 3; ++d)
    for_each_cell(gas.domain().box(), [&](int i, int j, int m) {
      gas.state().velocity[d](i, j, m) = problem.u(d, face(d, i, j, m), 0);
    });
  const double step = run.end / run.steps;
  const double force_at = run.scheme == TimeScheme::crank_nicolson ? 0.5 : 1.0;
  const Array3<double> drag =
      filled(gas.own(), [&](int i, int j, int m) { return Problem::drag(center(i, j, m)); });
  const bool steady = problem.growth == 0 && problem.oscillation == 0;
  gas.set_void_fraction(
      filled(gas.own(), [&](int i, int j, int m) { return problem.eps(center(i, j, m), 0); }));
  for (int s = 0; s < run.steps; ++s) {
    if (s == 0 || !steady) {
      CellVector force = make_vector(gas.own());
      for (int d = 0; d < 3; ++d)
        force[d] = filled(gas.own(), [&](int i, int j, int m) {
          return problem.source(d, center(i, j, m), (s + force_at) * step);
        });
      gas.set_void_fraction(filled(gas.own(), [&](int i, int j, int m) {
        return problem.eps(center(i, j, m), (s + 1) * step);
      }));
      gas.set_drag(drag, force);
    }
    gas.advance(step);
  }
  Errors sums;
  double shift = 0;
  for_each_cell(gas.own(), [&](int i, int j, int m) {
    shift += gas.state().pressure(i, j, m) - Problem::p(center(i, j, m));
  });
  const double count = static_cast<double>(gas.own().size());
  for_each_cell(gas.own(), [&](int i, int j, int m) {
    for (int d = 0; d < 3; ++d)
      sums.velocity +=
          std::abs(gas.state().velocity[d](i, j, m) - problem.u(d, face(d, i, j, m), run.end)) /
          count;
    sums.pressure +=
        std::abs(gas.state().pressure(i, j, m) - Problem::p(center(i, j, m)) - shift / count) /
        count;
  });
  return {gas.state().velocity, gas.pressure(), sums};
}

Errors errors(const Problem& problem, const Scheme& run) {
  return solve(problem, run).error;
}

Errors orders(const char* what, const Errors& coarse, const Errors& fine) {
  const Errors order{std::log2(coarse.velocity / fine.velocity),
                     std::log2(coarse.pressure / fine.pressure)};
  std::printf("%-44s order %.3f of u (%.3e, %.3e), %.3f of p (%.3e, %.3e)\n", what, order.velocity,
              coarse.velocity, fine.velocity, order.pressure, coarse.pressure, fine.pressure);
  return order;
}

// Of the steady flow.
Errors orders_in_space(const char* what, const Problem& problem, Scheme run) {
  const Errors coarse = errors(problem, run);
  run.cells *= 2;
  return orders(what, coarse, errors(problem, run));
}

TEST(gas_manufactured, schemes_of_second_order_reach_it_with_varying_void_fraction_and_drag) {
  Scheme run;
  run.cells = 24;
  run.steps = 60;
  run.end = 3;
  const std::pair<Convection, const char*> schemes[] = {
      {Convection::central, "central"}, {Convection::quick, "quick"}, {Convection::tvd, "tvd"}};
  for (const auto& [convection, name] : schemes) {
    run.convection = convection;
    const Errors order = orders_in_space(name, Problem{}, run);
    EXPECT_GT(order.velocity, 1.9) << name;
    EXPECT_GT(order.pressure, 1.9) << name;
  }
}

TEST(gas_manufactured, upwind_reaches_first_order) {
  Scheme run;
  run.convection = Convection::upwind;
  run.cells = 48;
  run.steps = 60;
  run.end = 3;
  const Errors order = orders_in_space("upwind", Problem{}, run);
  EXPECT_GT(order.velocity, 0.9);
  EXPECT_LT(order.velocity, 1.3);
}

TEST(gas_manufactured, three_dimensions_and_model_b_reach_second_order) {
  Scheme run;
  run.convection = Convection::tvd;
  run.cells = 12;
  run.steps = 30;
  run.end = 1.5;
  Problem problem;
  problem.with_y = true;
  EXPECT_GT(orders_in_space("tvd, 3-D", problem, run).velocity, 1.9);
  problem = {};
  problem.model = GasModel::b;
  run.convection = Convection::central;
  run.cells = 24;
  EXPECT_GT(orders_in_space("central, model B", problem, run).velocity, 1.9);
}

// Against the solution with many steps on the same grid: the error in space drops out.
void expect_order_in_time(const char* what, Scheme run, int steps, double bound) {
  Problem problem;
  problem.growth = 0.05;
  problem.oscillation = 0.5;
  run.cells = 16;
  run.end = 0.4;
  const auto at = [&](int n) {
    run.steps = n;
    return solve(problem, run);
  };
  const Solution reference = at(16 * steps);
  const auto error = [&](const Solution& solution) {
    double sum = 0;
    for (const int d : {0, 2})
      for (std::size_t n = 0; n < reference.velocity[d].size(); ++n)
        sum += std::abs(solution.velocity[d][n] - reference.velocity[d][n]);
    return sum / static_cast<double>(2 * reference.velocity[0].size());
  };
  const double coarse = error(at(steps));
  const double fine = error(at(2 * steps));
  const double order = std::log2(coarse / fine);
  std::printf("%-44s order %.3f in time (%.3e, %.3e)\n", what, order, coarse, fine);
  EXPECT_GT(order, bound) << what;
}

TEST(gas_manufactured, time_schemes_reach_their_orders_with_drag_and_moving_void_fraction) {
  Scheme run;
  expect_order_in_time("implicit Euler", run, 8, 0.95);
  run.scheme = TimeScheme::crank_nicolson;
  expect_order_in_time("Crank-Nicolson", run, 8, 1.9);
}

TEST(gas_manufactured, simple_and_simplec_reach_the_same_steady_flow) {
  Scheme run;
  run.cells = 24;
  run.steps = 30;
  run.end = 3;
  const Errors projection = errors(Problem{}, run);
  for (const PressureVelocity method : {PressureVelocity::simple, PressureVelocity::simplec}) {
    run.method = method;
    const Errors outer = errors(Problem{}, run);
    std::printf("error of u: projection %.4e, outer iterations %.4e\n", projection.velocity,
                outer.velocity);
    // The same equations in space: the discrete steady flow is the same but for the tolerances.
    EXPECT_NEAR(outer.velocity, projection.velocity, 0.01 * projection.velocity);
  }
}

}  // namespace
}  // namespace gasgrain
