// The implicit transport of a scalar.
#include <gtest/gtest.h>

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/scalars/scalar_equation.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

class gas_scalar : public testing::Test {
 protected:
  static BoxGrid grid() {
    BoxGrid grid;
    grid.hi = Vec3(0.08, 0.06, 0.05);
    grid.cells = {8, 6, 5};
    grid.periodic = {false, true, false};
    return grid;
  }
  gas_scalar() : domain_(grid(), self()), halo_(domain_), terms_(domain_.box()) {
    for (Array3<double>& flux : flux_) flux = Array3<double>(domain_.box());
  }
  void fill(Array3<double>& field) {
    halo_.exchange({&field});
    fill_ghost_cells(domain_, field);
  }
  // Mass and fluxes as they come, those of the sides included.
  void stir(double speed) {
    for (int d = 0; d < 3; ++d)
      for_each_cell(domain_.faces(d), [&](int i, int j, int k) {
        flux_[d](i, j, k) = speed * (scatter(i + 3 * d, j, k) - 0.5);
      });
    for_each_cell(domain_.own(), [&](int i, int j, int k) {
      terms_.mass(i, j, k) = 0.4 + 0.6 * scatter(k, j, i);
      terms_.conductance(i, j, k) = 1e-3 * scatter(j, k, i);
    });
    halo_.exchange({&flux_[0], &flux_[1], &flux_[2]});
    for (int d = 0; d < 3; ++d) fill_ghost_fluxes(domain_, d, flux_[d]);
    fill(terms_.conductance);
  }

  Domain domain_;
  Halo halo_;
  ScalarTerms terms_;
  std::array<Array3<double>, 3> flux_;
};

TEST_F(gas_scalar, uniform_scalar_stays_uniform_in_any_void_fraction_and_any_fluxes) {
  stir(5.0);
  const double value = 3.7;
  const std::vector<InflowFace> inflow{{4, {2, 2, 0}, 1.0, 1.0}};
  const std::vector<double> inflow_value{value};
  flux_[2](2, 2, 0) = 4.0;
  ScalarBoundary boundary{&inflow, &inflow_value, value, {}};
  boundary.side_value[0] = value;
  Array3<double> phi(domain_.box(), value);
  ScalarEquation equation(domain_, halo_, {true, false, 1e-14});
  for (int n = 0; n < 5; ++n) {
    equation.assemble(terms_, flux_, 1e-2, phi, boundary);
    EXPECT_TRUE(equation.solve(phi).converged);
  }
  // Round-off of a row's six sums, a step.
  for_each_cell(domain_.own(),
                [&](int i, int j, int k) { ASSERT_NEAR(phi(i, j, k), value, 1e-13 * value); });
}

TEST_F(gas_scalar, conduction_between_two_sides_is_linear) {
  terms_.mass.fill(1.0);
  terms_.conductance.fill(0.3);
  ScalarBoundary boundary;
  boundary.side_value[0] = 300.0;
  boundary.side_value[1] = 500.0;
  Array3<double> phi(domain_.box(), 400.0);
  ScalarEquation equation(domain_, halo_, {true, false, 1e-13});
  for (int n = 0; n < 20; ++n) {
    equation.assemble(terms_, flux_, 1.0, phi, boundary);
    equation.solve(phi);
  }
  // Sweeps stop when they change 1e-13; their sum is larger.
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    ASSERT_NEAR(phi(i, j, k), 300.0 + 25.0 * (i + 0.5), 1e-7);
  });
}

TEST_F(gas_scalar, inflow_brings_its_value_with_its_mass_flux) {
  // Through-flow along z from one patch of a floor: a steady column holds the patch's value, and
  // the balance of a step is the mass that entered times the value.
  terms_.mass.fill(1.2);
  flux_[2].fill(0.6);
  std::vector<InflowFace> inflow;
  for_each_cell(domain_.side_faces(4), [&](int i, int j, int k) {
    inflow.push_back({4, {i, j, k}, 0.5, 0.25});
  });
  const std::vector<double> value(inflow.size(), 2.0);
  Array3<double> phi(domain_.box(), 0.0);
  ScalarEquation equation(domain_, halo_, {false, false, 1e-13});
  const double step = 1e-3;
  equation.assemble(terms_, flux_, step, phi, {&inflow, &value, 0.0, {}});
  equation.solve(phi);
  double held = 0;
  double left = 0;
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    held += 1.2 * phi(i, j, k) * domain_.grid().cell_volume();
    if (k == 4) left += step * 0.6 * phi(i, j, k) * 1e-4;
  });
  const double entered = step * 0.6 * 2.0 * 0.08 * 0.06;
  EXPECT_NEAR(held + left, entered, 1e-12 * entered);
}

TEST_F(gas_scalar, positive_scalar_stays_positive_at_a_high_courant_number) {
  stir(0);
  terms_.mass.fill(1.0);
  flux_[0].fill(50.0);  // Courant number 50
  flux_[2].fill(-20.0);
  Array3<double> phi = filled(
      domain_.box(), [](int i, int j, int k) { return scatter(i, j, k) > 0.7 ? 1.0 : 1e-12; });
  fill(phi);
  ScalarBoundary boundary;
  boundary.outside = 1e-12;
  ScalarEquation equation(domain_, halo_, {true, true, 1e-6});
  for (int n = 0; n < 10; ++n) {
    equation.assemble(terms_, flux_, 1e-2, phi, boundary);
    EXPECT_TRUE(equation.solve(phi).converged);
    for_each_cell(domain_.own(), [&](int i, int j, int k) { ASSERT_GT(phi(i, j, k), 0.0) << n; });
  }
}

TEST_F(gas_scalar, fixed_cell_keeps_its_value_and_its_neighbours_see_it) {
  stir(1.0);
  terms_.conductance.fill(1.0);
  Array3<double> phi(domain_.box(), 1.0);
  ScalarBoundary boundary;
  boundary.outside = 1.0;
  ScalarEquation equation(domain_, halo_, {false, true, 1e-10});
  equation.assemble(terms_, flux_, 1.0, phi, boundary);
  equation.fix(phi.offset(3, 3, 2), 9.0);
  equation.solve(phi);
  EXPECT_EQ(phi(3, 3, 2), 9.0);
  EXPECT_GT(phi(4, 3, 2), 2.0);
}

}  // namespace
}  // namespace gasgrain
