// What the gas lends besides velocity and pressure gradient: vorticity, acceleration, viscous
// force.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

using Flow = std::function<Vec3(const Vec3& x)>;

constexpr FurtherMeans all_further{true, true, true};

GasInput uneven_box(const Sides& sides) {
  GasInput input = box({6, 5, 7}, Vec3(0.3, 0.2, 0.42), sides);
  input.viscosity = 0.04;
  return input;
}

constexpr Sides free_slip{&wall_free_slip, &wall_free_slip, &wall_free_slip,
                          &wall_free_slip, &wall_free_slip, &wall_free_slip};

// The means of a given flow that holds for an interval, whose velocity at its beginning is `start`
// times the flow.
struct GivenFlow {
  GivenFlow(const GasInput& input, const Flow& flow, double start = 1.0, double interval = 1.0)
      : domain(input.grid, self()), means(domain, input) {
    means.ask_for(all_further);
    CellVector u = make_vector(domain.box());
    CellVector before = make_vector(domain.box());
    const Vec3 h = input.grid.spacing();
    for (int d = 0; d < 3; ++d)
      for_each_cell(domain.box(), [&](int i, int j, int k) {
        Vec3 x(i + 0.5, j + 0.5, k + 0.5);
        x[d] -= 0.5;
        u[d](i, j, k) = flow(input.grid.lo + x.cwiseProduct(h))[d];
        before[d](i, j, k) = start * u[d](i, j, k);
      });
    means.begin(before, interval);
    means.add_velocity(u, 1.0);
    means.end(u, interval);
  }

  [[nodiscard]] Vec3 centre(int i, int j, int k) const {
    const BoxGrid& grid = domain.grid();
    return grid.lo + Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(grid.spacing());
  }
  // In all cells.
  void expect(const CellVector& field, const Flow& exact, double tolerance) const {
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const Vec3 value(field[0](i, j, k), field[1](i, j, k), field[2](i, j, k));
      EXPECT_NEAR((value - exact(centre(i, j, k))).norm(), 0.0, tolerance)
          << "cell " << i << " " << j << " " << k;
    });
  }

  Domain domain;
  IntervalMeans means;
};

Vec3 nothing(const Vec3&) {
  return Vec3::Zero();
}

TEST(gas_lent_fields, are_empty_and_not_made_unless_asked_for) {
  GasSolver gas(uneven_box(free_slip), self());
  gas.advance(1e-3);
  EXPECT_EQ(gas.mean_vorticity()[0].size(), 0U);
  EXPECT_EQ(gas.mean_acceleration()[0].size(), 0U);
  EXPECT_EQ(gas.mean_viscous_force()[0].size(), 0U);
  gas.ask_for({false, true, false});
  gas.advance(1e-3);
  EXPECT_EQ(gas.mean_vorticity()[0].size(), 0U);
  EXPECT_EQ(gas.mean_acceleration()[0].size(), 6U * 5U * 7U);
}

TEST(gas_lent_fields, of_a_linear_shear_are_exact) {
  const Flow shear = [](const Vec3& x) {
    return Vec3(3.0 * x.y() - 2.0 * x.z(), 0.0, 5.0 * x.x());
  };
  const GivenFlow given(uneven_box(free_slip), shear);
  given.expect(
      given.means.vorticity, [](const Vec3&) { return Vec3(0.0, -7.0, -3.0); }, 1e-12);
  given.expect(given.means.viscous_force, nothing, 1e-12);
}

TEST(gas_lent_fields, of_a_rotation_have_twice_its_rate_and_its_centripetal_acceleration) {
  const Vec3 rate(1.0, -2.0, 0.5);
  const GivenFlow given(uneven_box(free_slip),
                        [&](const Vec3& x) -> Vec3 { return rate.cross(x); });
  given.expect(
      given.means.vorticity, [&](const Vec3&) -> Vec3 { return 2.0 * rate; }, 1e-12);
  given.expect(
      given.means.acceleration, [&](const Vec3& x) -> Vec3 { return rate.cross(rate.cross(x)); },
      1e-12);
  given.expect(given.means.viscous_force, nothing, 1e-12);
}

TEST(gas_lent_fields, of_a_stagnation_flow_have_the_acceleration_of_its_paths) {
  const GivenFlow given(uneven_box(free_slip),
                        [](const Vec3& x) { return Vec3(x.x(), -x.y(), 0.0); });
  given.expect(given.means.vorticity, nothing, 1e-12);
  given.expect(
      given.means.acceleration, [](const Vec3& x) { return Vec3(x.x(), x.y(), 0.0); }, 1e-12);
}

TEST(gas_lent_fields, of_a_flow_that_grows_have_its_change_over_the_interval) {
  const double start = 0.6;
  const double interval = 0.02;
  const GivenFlow given(
      uneven_box(free_slip), [](const Vec3&) { return Vec3(1.0, 2.0, -3.0); }, start, interval);
  given.expect(
      given.means.acceleration,
      [&](const Vec3&) -> Vec3 { return (1.0 - start) / interval * Vec3(1.0, 2.0, -3.0); }, 1e-10);
}

// u = (y^2, 0, 0) and, where div u is not 0, u = (x^2, 0, 0): mu (2 + 2/3).
TEST(gas_lent_fields, of_quadratic_profiles_have_the_exact_viscous_force) {
  const double mu = uneven_box(free_slip).viscosity;
  const GivenFlow across(uneven_box(free_slip),
                         [](const Vec3& x) { return Vec3(x.y() * x.y(), 0.0, 0.0); });
  across.expect(
      across.means.viscous_force, [&](const Vec3&) { return Vec3(2.0 * mu, 0.0, 0.0); }, 1e-12);
  const GivenFlow along(uneven_box(free_slip),
                        [](const Vec3& x) { return Vec3(0.0, 0.0, x.z() * x.z()); });
  along.expect(
      along.means.viscous_force, [&](const Vec3&) { return Vec3(0.0, 0.0, 8.0 / 3.0 * mu); },
      1e-12);
  // The gradient of a divergence across the component: u = (x y, 0, 0) has mu / 3 along y.
  const GivenFlow mixed(uneven_box(free_slip),
                        [](const Vec3& x) { return Vec3(x.x() * x.y(), 0.0, 0.0); });
  mixed.expect(
      mixed.means.viscous_force, [&](const Vec3&) { return Vec3(0.0, mu / 3.0, 0.0); }, 1e-12);
}

// Away from walls, where the flow may be any.
TEST(gas_lent_fields, are_of_second_order_in_the_cell_size) {
  const Flow flow = [](const Vec3& x) {
    return Vec3(std::sin(3.0 * x.y()) * x.z(), std::cos(2.0 * x.x()) + x.z() * x.z() * x.z(),
                std::exp(x.x()) * x.y());
  };
  const auto curl = [](const Vec3& x) {
    return Vec3(std::exp(x.x()) - 3.0 * x.z() * x.z(),
                std::sin(3.0 * x.y()) - std::exp(x.x()) * x.y(),
                -2.0 * std::sin(2.0 * x.x()) - 3.0 * std::cos(3.0 * x.y()) * x.z());
  };
  const auto convection = [&](const Vec3& x) -> Vec3 {
    Eigen::Matrix3d gradient;  // d u_a / d x_b
    gradient << 0.0, 3.0 * std::cos(3.0 * x.y()) * x.z(), std::sin(3.0 * x.y()),
        -2.0 * std::sin(2.0 * x.x()), 0.0, 3.0 * x.z() * x.z(), std::exp(x.x()) * x.y(),
        std::exp(x.x()), 0.0;
    return gradient * flow(x);
  };
  const auto laplace = [](const Vec3& x) {
    return Vec3(-9.0 * std::sin(3.0 * x.y()) * x.z(), -4.0 * std::cos(2.0 * x.x()) + 6.0 * x.z(),
                std::exp(x.x()) * x.y());
  };
  std::vector<Vec3> errors;
  for (const int n : {8, 16, 32}) {
    GasInput input = box({n, n, n}, Vec3(1.0, 1.0, 1.0), free_slip);
    input.viscosity = 1.0;
    const GivenFlow given(input, flow);
    Vec3 greatest = Vec3::Zero();
    for_each_cell(given.domain.own(), [&](int i, int j, int k) {
      const Vec3 x = given.centre(i, j, k);
      const auto error = [&](const CellVector& field, const Vec3& exact) {
        return (Vec3(field[0](i, j, k), field[1](i, j, k), field[2](i, j, k)) - exact).norm();
      };
      // A face on a side takes the value of the other: first order there.
      const bool inside = std::min({i, j, k}) > 0 && std::max({i, j, k}) < n - 1;
      greatest = greatest.cwiseMax(Vec3(
          error(given.means.vorticity, curl(x)), error(given.means.acceleration, convection(x)),
          inside ? error(given.means.viscous_force, laplace(x)) : 0.0));
    });
    errors.push_back(greatest);
  }
  for (std::size_t n = 1; n < errors.size(); ++n)
    for (int field = 0; field < 3; ++field)
      EXPECT_NEAR(std::log2(errors[n - 1][field] / errors[n][field]), 2.0, 0.2)
          << "field " << field << ", " << errors[n][field];
}

// Gas that gravity draws along a periodic axis through a box without walls.
TEST(gas_lent_fields, of_a_falling_column_have_its_acceleration) {
  const Sides endless{&periodic_side, &periodic_side, &periodic_side,
                      &periodic_side, &periodic_side, &periodic_side};
  GasInput input = uneven_box(endless);
  input.gravity = Vec3(0.0, 0.0, -9.81);
  GasSolver gas(input, self());
  gas.ask_for(all_further);
  const double tolerance = 1e-4;  // the momentum equation is solved to 1e-5 of the velocity
  for (int n = 0; n < 3; ++n) {
    gas.advance(0.01);
    for_each_cell(gas.own(), [&](int i, int j, int k) {
      EXPECT_NEAR(gas.mean_acceleration()[2](i, j, k), -9.81, 9.81 * tolerance);
      EXPECT_NEAR(gas.mean_vorticity()[0](i, j, k), 0.0, tolerance);
      EXPECT_NEAR(gas.mean_viscous_force()[2](i, j, k), 0.0, tolerance);
    });
  }
}

// In developed flow between walls the viscous force carries the gas's weight in every cell, those
// at the walls included.
TEST(gas_lent_fields, of_a_developed_channel_balance_what_drives_it) {
  const Sides channel{&wall_no_slip,  &wall_no_slip,  &periodic_side,
                      &periodic_side, &periodic_side, &periodic_side};
  GasInput input = box({8, 1, 2}, Vec3(0.01, 0.01, 0.01), channel);
  input.viscosity = 1e-3;
  input.gravity = Vec3(0.0, 0.0, -9.81);
  input.step = 0.1;
  input.courant_max = 1e6;
  GasSolver gas(input, self());
  gas.advance(30.0);
  gas.ask_for(all_further);
  gas.advance(1.0);
  const double weight = input.density * 9.81;
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    EXPECT_NEAR(gas.mean_viscous_force()[2](i, j, k), weight, 1e-6 * weight);
    EXPECT_NEAR(gas.mean_acceleration()[2](i, j, k), 0.0, 1e-6);
  });
  // curl u = -dw/dx along y, which falls linearly from wall to wall.
  const double at_wall = weight / input.viscosity * 0.005;
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(gas.mean_vorticity()[1](i, 0, 0), at_wall * (1.0 - (i + 0.5) / 4), 1e-6 * at_wall);
}

TEST(gas_lent_fields, change_nothing_in_the_flow) {
  GasInput input = uneven_box(walls);
  input.sides[5] = &outlet;
  input.inflows = {whole_side(input, 4, 0.5)};
  input.step = 1e-2;
  GasSolver with(input, self());
  GasSolver without(input, self());
  with.ask_for(all_further);
  for (int n = 0; n < 5; ++n) {
    with.advance(0.02);
    without.advance(0.02);
  }
  for (int d = 0; d < 3; ++d) {
    EXPECT_TRUE(std::equal(with.state().velocity[d].begin(), with.state().velocity[d].end(),
                           without.state().velocity[d].begin()));
    EXPECT_TRUE(std::equal(with.mean_pressure_gradient()[d].begin(),
                           with.mean_pressure_gradient()[d].end(),
                           without.mean_pressure_gradient()[d].begin()));
  }
}

}  // namespace
}  // namespace gasgrain
