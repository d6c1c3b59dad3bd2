// Turbulence models at a point, at walls and in a run.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <filesystem>

#include "gas_solver/turbulence/launder_spalding.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

Sides all_periodic() {
  Sides sides;
  sides.fill(&periodic_side);
  return sides;
}

GasInput small(TurbulenceModel model, const Int3& cells = {4, 5, 6},
               const Vec3& size = Vec3(0.04, 0.1, 0.03)) {
  GasInput input = box(cells, size, all_periodic());
  input.join_periodic_sides();
  input.turbulence.model = model;
  input.turbulence.smagorinsky_constant = 0.12;
  return input;
}

using VectorField = std::function<Vec3(const Vec3& x)>;

// A model with the velocity of a function, the layers around the grid included.
struct Sampled {
  explicit Sampled(const GasInput& input)
      : domain(input.grid, self()), halo(domain), state(domain.box()), model(domain, input, halo) {}
  void set(const VectorField& velocity) {
    const Vec3 h = domain.grid().spacing();
    for (int d = 0; d < 3; ++d)
      for_each_cell(domain.box(), [&](int i, int j, int k) {
        Vec3 x = h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
        x[d] -= 0.5 * h[d];
        state.velocity[d](i, j, k) = velocity(x)[d];
      });
  }
  TurbulenceReport update(double step) { return model.update(state, step, {}); }
  Domain domain;
  Halo halo;
  GasState state;
  Turbulence model;
};

TEST(gas_turbulence, smagorinsky_in_linear_shear_is_exact) {
  const GasInput input = small(TurbulenceModel::smagorinsky);
  const double width = std::cbrt(0.01 * 0.02 * 0.005);
  const double shear = 30;
  const double expected = input.viscosity + input.density * std::pow(0.12 * width, 2) * shear;
  for (int along = 0; along < 3; ++along)
    for (int across = 0; across < 3; ++across) {
      if (along == across) continue;
      Sampled s(input);
      s.set([=](const Vec3& x) { return Vec3(shear * x[across] * Vec3::Unit(along)); });
      s.update(1.0);
      // Differences of velocities of about 1: round-off only.
      for_each_cell(s.domain.box(), [&](int i, int j, int k) {
        ASSERT_NEAR(s.model.viscosity()(i, j, k), expected, 1e-12 * expected);
      });
    }
}

TEST(gas_turbulence, smagorinsky_in_plane_strain_is_exact) {
  const GasInput input = small(TurbulenceModel::smagorinsky);
  Sampled s(input);
  s.set([](const Vec3& x) { return Vec3(7 * x[0], -7 * x[1], 0); });
  s.update(1.0);
  // 2 S_ij S_ij = 2 (7^2 + 7^2)
  const double width = std::cbrt(0.01 * 0.02 * 0.005);
  const double expected = input.viscosity + input.density * std::pow(0.12 * width, 2) * 14;
  EXPECT_NEAR(s.model.viscosity()(2, 2, 2), expected, 1e-12 * expected);
}

TEST(gas_turbulence, smagorinsky_is_zero_at_rest_in_rotation_and_in_uniform_swelling) {
  const GasInput input = small(TurbulenceModel::smagorinsky);
  const Vec3 turn(3, -5, 11);
  const std::vector<VectorField> fields{
      [](const Vec3&) { return Vec3(Vec3::Zero()); },
      [](const Vec3&) { return Vec3(20, -3, 4); },
      [=](const Vec3& x) { return Vec3(turn.cross(x)); },
      [](const Vec3& x) { return Vec3(9 * x); },
  };
  for (const VectorField& field : fields) {
    Sampled s(input);
    s.set(field);
    s.update(1.0);
    // |S| <= 1e-12 1/s of round-off.
    EXPECT_NEAR(s.model.viscosity()(1, 2, 3), input.viscosity, 1e-12 * input.viscosity);
  }
}

TEST(gas_turbulence, axes_may_be_permuted) {
  const auto field = [](const Vec3& x) {
    return Vec3(std::sin(90 * x[0]) * x[1], std::cos(70 * x[2] + 40 * x[0]),
                x[0] * x[1] * 100 + std::sin(50 * x[2]));
  };
  const Int3 cells{4, 5, 6};
  const Vec3 size(0.04, 0.1, 0.03);
  for (const TurbulenceModel model : {TurbulenceModel::smagorinsky, TurbulenceModel::k_epsilon}) {
    Sampled original(small(model, cells, size));
    original.set(field);
    original.update(1e-3);
    // Axis d of the turned case is axis d - 1 of the original.
    Sampled turned(small(model, {cells[2], cells[0], cells[1]}, Vec3(size[2], size[0], size[1])));
    turned.set([&](const Vec3& x) {
      const Vec3 u = field(Vec3(x[1], x[2], x[0]));
      return Vec3(u[2], u[0], u[1]);
    });
    turned.update(1e-3);
    // The order of sums differs, for k and e also that of the sweeps (to 1e-6 of their change).
    const double tolerance = model == TurbulenceModel::smagorinsky ? 1e-12 : 1e-5;
    for_each_cell(original.domain.own(), [&](int i, int j, int k) {
      const double expected = original.model.viscosity()(i, j, k);
      ASSERT_NEAR(turned.model.viscosity()(k, i, j), expected, tolerance * expected);
    });
  }
}

TEST(gas_turbulence, filter_of_a_grid_one_cell_deep_is_that_of_its_plane) {
  BoxGrid grid;
  grid.hi = Vec3(0.1, 0.02, 0.4);
  grid.cells = {10, 1, 10};
  EXPECT_NEAR(filter_width(grid), std::sqrt(0.01 * 0.04), 1e-15);
  grid.cells[1] = 2;
  EXPECT_NEAR(filter_width(grid), std::cbrt(0.01 * 0.01 * 0.04), 1e-15);
}

TEST(gas_turbulence, homogeneous_turbulence_decays_by_the_power_law_at_first_order_in_time) {
  const double k0 = 1;
  const double e0 = 10;
  const double time = 0.5;
  const double n = launder_spalding::c_2 - 1;
  const double expected_k = k0 * std::pow(1 + n * e0 * time / k0, -1 / n);
  const double expected_e = e0 * std::pow(expected_k / k0, launder_spalding::c_2);
  std::vector<double> errors;
  for (const int steps : {50, 100, 200}) {
    Sampled s(small(TurbulenceModel::k_epsilon));
    s.model.k_epsilon()->set_uniform({k0, e0});
    for (int i = 0; i < steps; ++i) s.update(time / steps);
    errors.push_back(s.model.k_epsilon()->k()(1, 1, 1) / expected_k - 1);
    const double e = s.model.k_epsilon()->epsilon()(1, 1, 1);
    EXPECT_NEAR(e, expected_e, 0.1 * expected_e);
  }
  const double order = std::log2(errors[1] / errors[2]);
  EXPECT_NEAR(order, 1.0, 0.1);
  // The first of 200 steps takes e0/k0 dt = 0.025 of k.
  EXPECT_LT(std::abs(errors[2]), 0.02);
}

TEST(gas_turbulence, homogeneous_shear_tends_to_the_equilibrium_of_the_model) {
  // d(e/k)/dt = 0: G / (rho e) = (C_2 - 1)/(C_1 - 1), and G = C_mu rho k^2 S^2 / e.
  using namespace launder_spalding;
  const double expected = std::sqrt((c_2 - 1) / (c_1 - 1) / c_mu);
  GasInput input = small(TurbulenceModel::k_epsilon, {2, 2, 2});
  input.viscosity = 1e-3;  // its 1e5-fold is not reached
  Sampled s(input);
  const double shear = 10;
  s.set([=](const Vec3& x) { return Vec3(0, 0, shear * x[0]); });
  s.model.k_epsilon()->set_uniform({0.01, 0.05});
  for (int i = 0; i < 4000; ++i) EXPECT_EQ(s.update(1e-3).capped, 0);
  const double k = s.model.k_epsilon()->k()(1, 1, 1);
  const double e = s.model.k_epsilon()->epsilon()(1, 1, 1);
  // First order in time: S dt = 0.01.
  EXPECT_NEAR(shear * k / e, expected, 0.01 * expected);
}

TEST(gas_turbulence, wall_law_is_continuous_and_in_equilibrium_production_is_dissipation) {
  using namespace launder_spalding;
  EXPECT_NEAR(std::log(wall_e * crossing) / kappa, crossing, 1e-8);
  const double density = 1.2;
  const double viscosity = 1.8e-5;
  const double y = 0.002;
  for (const double friction_velocity : {0.02, 0.5, 3.0}) {
    const double k = friction_velocity * friction_velocity / std::sqrt(c_mu);
    const double y_star = wall_distance(density, viscosity, k, y);
    EXPECT_NEAR(y_star, density * friction_velocity * y / viscosity, 1e-12 * y_star);
    const double u = friction_velocity * wall_velocity(y_star);
    const double stress = wall_coefficient(density, viscosity, k, y) * u;
    EXPECT_NEAR(stress, density * friction_velocity * friction_velocity, 1e-12 * stress);
    EXPECT_NEAR(stress * u / y, density * k * wall_dissipation_rate(density, viscosity, k, y),
                1e-12 * stress * u / y);
  }
}

TEST(gas_turbulence, faces_of_inflow_are_no_walls) {
  GasInput input = box({6, 4, 8}, Vec3(0.06, 0.04, 0.08), walls);
  input.sides[2] = input.sides[3] = &periodic_side;
  input.join_periodic_sides();
  InflowPatch jet;
  jet.side = 4;
  jet.outline.bounds = {{0.025, 0.0}, {0.035, 0.04}};
  jet.velocity = 20;
  input.inflows = {jet};
  const Domain domain(input.grid, self());
  WallSides sides(domain, input);
  ASSERT_EQ(sides.sides().size(), 4U);
  const WallSide& floor = sides.sides()[2];
  ASSERT_EQ(floor.side, 4);
  for (int i = 0; i < 6; ++i)
    for (const int j : {-2, 0, 3, 5}) EXPECT_EQ(floor.is_wall(i, j, 0), i != 2 && i != 3) << i;
  EXPECT_NEAR(sides.coefficient(4)(0, 0, 0), input.viscosity / 0.005, 1e-18);
}

TEST(gas_turbulence, inflow_carries_the_intensity_and_length_it_is_given) {
  GasInput input = box({6, 4, 8}, Vec3(0.06, 0.04, 0.08), walls);
  InflowPatch jet;
  jet.side = 4;
  jet.outline = {{{0.026, 0.018}, {0.030, 0.022}}, true};
  jet.velocity = 20;
  input.inflows = {jet};
  input.turbulence.intensity = 0.1;
  const double k = 1.5 * 2.0 * 2.0;
  for (const double length : {0.0, 1e-3}) {
    input.turbulence.length_scale = length;
    InflowTurbulence turbulence(input);
    const Domain domain(input.grid, self());
    Inflow inflow(domain, input.inflows, input.density);
    turbulence.update(inflow.at(0, {}));
    ASSERT_GT(turbulence.k().size(), 0U);
    for (std::size_t n = 0; n < turbulence.k().size(); ++n) {
      // The face's own share f cancels: what enters is that of the opening.
      EXPECT_NEAR(turbulence.k()[n], k, 1e-12 * k);
      const double expected =
          std::pow(0.09, 0.75) * std::pow(k, 1.5) / (length > 0 ? length : 0.07 * 0.004);
      EXPECT_NEAR(turbulence.e()[n], expected, 1e-12 * expected);
    }
    EXPECT_GE(launder_spalding::eddy_viscosity(input.density, turbulence.ambient().k,
                                               turbulence.ambient().e),
              9.99 * input.viscosity);
  }
}

TEST(gas_turbulence, walls_and_gas_may_move_together) {
  GasInput input = box({4, 4, 6}, Vec3(0.04, 0.04, 0.06), walls);
  input.sides[0] = input.sides[1] = &periodic_side;
  input.join_periodic_sides();
  input.turbulence.model = TurbulenceModel::k_epsilon;
  const Vec3 moved(4, 0, 0);
  const auto shear = [](const Vec3& x) { return Vec3(50 * x[2], 0, 0); };
  Sampled still(input);
  still.set(shear);
  for (Vec3& velocity : input.wall_velocity) velocity = moved;
  Sampled moving(input);
  moving.set([&](const Vec3& x) { return Vec3(shear(x) + moved); });
  for (Sampled* s : {&still, &moving})
    for (int n = 0; n < 5; ++n) s->update(1e-3);
  for_each_cell(still.domain.own(), [&](int i, int j, int k) {
    const double expected = still.model.k_epsilon()->k()(i, j, k);
    ASSERT_NEAR(moving.model.k_epsilon()->k()(i, j, k), expected, 1e-10 * expected);
  });
  EXPECT_GT(still.model.k_epsilon()->k()(1, 1, 5), 2 * still.model.k_epsilon()->k()(1, 1, 0));
}

GasInput jet_in_bed(TurbulenceModel model) {
  GasInput input = thin_jet();
  input.step = 0.5e-3;
  input.turbulence.model = model;
  return input;
}

void bed_at(GasSolver& gas, int n) {
  set_bed(
      gas, [n](int i, int j, int k) { return k < 25 ? 0.42 + 0.2 * scatter(i, j + n, k) : 1.0; },
      [](int, int, int k) { return k < 25 ? 2000.0 : 0.0; }, constant_zero);
}

TEST(gas_turbulence, jet_at_a_high_courant_number_keeps_k_and_epsilon_positive_without_a_floor) {
  for (const bool with_bed : {true, false}) {
    GasSolver gas(jet_in_bed(TurbulenceModel::k_epsilon), self());
    double courant = 0;
    double greatest = 0;
    double greatest_k = 0;
    long clamped = 0;
    long missed = 0;
    for (int n = 0; n < 60; ++n) {
      if (with_bed) bed_at(gas, n);
      const GasReport report = gas.advance(0.5e-3);
      courant = std::max(courant, report.courant_max);
      greatest = std::max(greatest, greatest_speed(gas));
      clamped += report.turbulence_clamped;
      missed += report.turbulence_not_converged;
      const KEpsilon& model = *gas.turbulence()->k_epsilon();
      for_each_cell(gas.own(), [&](int i, int j, int k) {
        ASSERT_GT(model.k()(i, j, k), 0.0);
        ASSERT_GT(model.epsilon()(i, j, k), 0.0);
        greatest_k = std::max(greatest_k, model.k()(i, j, k));
      });
    }
    EXPECT_GT(courant, 15);
    EXPECT_EQ(clamped, 0);
    EXPECT_EQ(missed, 0);
    EXPECT_LT(greatest, 1.25 * 150);
    EXPECT_LT(greatest_k, 150 * 150);
  }
}

TEST(gas_turbulence, smagorinsky_without_its_constant_is_the_run_without_a_model) {
  GasInput input = jet_in_bed(TurbulenceModel::none);
  input.viscosity = 0.01;  // so that stresses matter
  GasSolver off(input, self());
  EXPECT_EQ(off.turbulence(), nullptr);
  input.turbulence.model = TurbulenceModel::smagorinsky;
  input.turbulence.smagorinsky_constant = 0;
  GasSolver on(input, self());
  for (int n = 0; n < 10; ++n)
    for (GasSolver* gas : {&off, &on}) {
      bed_at(*gas, n);
      gas->advance(0.5e-3);
    }
  // Sums of viscosities in another order: round-off, times the iterations' tolerance at worst.
  for (int d = 0; d < 3; ++d)
    for_each_cell(off.own(), [&](int i, int j, int k) {
      ASSERT_NEAR(on.state().velocity[d](i, j, k), off.state().velocity[d](i, j, k), 1e-7);
    });
}

TEST(gas_turbulence, model_that_is_on_shows) {
  for (const TurbulenceModel model : {TurbulenceModel::smagorinsky, TurbulenceModel::k_epsilon}) {
    GasSolver off(jet_in_bed(TurbulenceModel::none), self());
    GasSolver on(jet_in_bed(model), self());
    for (int n = 0; n < 10; ++n) {
      off.advance(0.5e-3);
      on.advance(0.5e-3);
    }
    double difference = 0;
    for_each_cell(off.own(), [&](int i, int j, int k) {
      difference = std::max(
          difference, std::abs(on.state().velocity[2](i, j, k) - off.state().velocity[2](i, j, k)));
    });
    EXPECT_GT(difference, 0.1);
  }
}

TEST(gas_turbulence, run_that_goes_on_from_a_checkpoint_is_bitwise_the_same) {
  const std::string file = testing::TempDir() + "gas_turbulence_test.h5";
  for (const TurbulenceModel model : {TurbulenceModel::smagorinsky, TurbulenceModel::k_epsilon}) {
    GasSolver whole(jet_in_bed(model), self());
    for (int n = 0; n < 6; ++n) {
      bed_at(whole, n);
      whole.advance(0.5e-3);
      if (n == 2) whole.write_checkpoint(file);
    }
    GasSolver second(jet_in_bed(model), self());
    second.read_checkpoint(file);
    for (int n = 3; n < 6; ++n) {
      bed_at(second, n);
      second.advance(0.5e-3);
    }
    for (int d = 0; d < 3; ++d)
      EXPECT_TRUE(std::equal(whole.state().velocity[d].begin(), whole.state().velocity[d].end(),
                             second.state().velocity[d].begin()));
    const auto& a = whole.turbulence()->viscosity();
    EXPECT_TRUE(std::equal(a.begin(), a.end(), second.turbulence()->viscosity().begin()));
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gasgrain
