// The multigrid on grids of which ranks share more than the finest, and the tests that one, two and
// four ranks share.
#pragma once

#include <gtest/gtest.h>

#include "gas_solver/pressure/multigrid.h"
#include "tests/unit/gas_pressure_cases.h"

namespace gasgrain::pressure_cases {

// Cells that ranks cut at odd places, several grids of more cells than every rank holds the whole
// of.
inline const std::vector<Case> shared_grids{
    {"bed", {41, 22, 38}, {wall, wall, wall, wall, wall, open}, -1, false},
    {"bed_between_periodic_sides",
     {38, 22, 41},
     {around, around, around, around, wall, open},
     -1,
     false},
    {"odd_counts_round_periodic_axes",
     {35, 27, 35},
     {around, around, around, around, wall, open},
     -1,
     false},
    {"sealed_bed_with_storage", {30, 34, 31}, gas_cases::walls, -1, true},
    {"sealed_bed", {46, 23, 29}, gas_cases::walls, -1, false},
    {"periodic_bed", {30, 30, 34}, {around, around, around, around, around, around}, -1, false},
    {"one_cell_deep", {110, 1, 131}, {wall, wall, wall, wall, wall, open}, -1, false},
};

inline BoxGrid cubes(const Case& c) {
  BoxGrid grid = grid_of(c);
  for (int d = 0; d < 3; ++d) grid.hi[d] = c.cells[d];
  return grid;
}

struct Solved {
  int iterations;
  Array3<double> solution;  // with the mean 0 where only differences are known
};

inline Solved with_multigrid(const Case& c, const Domain& domain) {
  PressureSystem system = posed(c, domain);
  PressureSolver solver(domain, PressureMethod::multigrid);
  Solved out;
  const double tolerance = 1e-10 * norm(domain, system.source);
  out.iterations = solver.solve(system, tolerance);
  // The residual is updated, and balanced, in sums of 1e4 numbers.
  EXPECT_LE(norm(domain, residual(domain, system)), 1.01 * tolerance);
  double sum = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) { sum += system.solution(i, j, k); });
  const double mean = system.singular
                          ? domain.comm().sum(sum) / static_cast<double>(domain.grid().all().size())
                          : 0.0;
  out.solution = Array3<double>(domain.own());
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    out.solution(i, j, k) = system.solution(i, j, k) - mean;
  });
  return out;
}

class gas_pressure_multigrid : public testing::TestWithParam<Case> {};

TEST_P(gas_pressure_multigrid, solution_and_iterations_are_those_of_one_rank) {
  const Domain alone(cubes(GetParam()), gas_cases::self());
  const Domain domain(cubes(GetParam()), Communicator(MPI_COMM_WORLD));
  const Solved expected = with_multigrid(GetParam(), alone);
  const Solved shared = with_multigrid(GetParam(), domain);
  // Ten decades at a fifth to a third of the residual an iteration; where ranks, or the two ends of
  // a periodic axis, meet, the smoother takes old values.
  EXPECT_LE(expected.iterations, 22);
  EXPECT_LE(shared.iterations, expected.iterations + 4);
  double scale = 0;
  for (const double x : expected.solution) scale = std::max(scale, std::abs(x));
  // The residual is 1e-10 in the smooth parts of the solution, which the matrix makes least of, as
  // in the rough ones: the multigrid finds both.
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    ASSERT_NEAR(shared.solution(i, j, k), expected.solution(i, j, k), 1e-8 * scale);
  });
}

TEST_P(gas_pressure_multigrid, preconditioner_is_symmetric_and_positive) {
  const Domain domain(cubes(GetParam()), Communicator(MPI_COMM_WORLD));
  const PressureSystem system = posed(GetParam(), domain);
  Multigrid multigrid(domain);
  multigrid.set(system);
  const auto cells = static_cast<double>(domain.grid().all().size());
  const auto random = [&](int seed) {
    Array3<double> field(domain.own());
    double sum = 0;
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      field(i, j, k) = gas_cases::scatter(i + 7 * seed, k, j) - 0.5;
      sum += field(i, j, k);
    });
    const double mean = domain.comm().sum(sum) / cells;
    for (double& value : field) value -= mean;  // a residual of a singular system
    return field;
  };
  const Array3<double> a = random(1);
  const Array3<double> b = random(2);
  Array3<double> of_a(domain.box());
  Array3<double> of_b(domain.box());
  const double positive = multigrid.correction(a);
  multigrid.turn(of_a, 0.0);
  multigrid.correction(b);
  multigrid.turn(of_b, 0.0);
  double a_b = 0;
  double b_a = 0;
  double a_a = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    a_b += a(i, j, k) * of_b(i, j, k);
    b_a += b(i, j, k) * of_a(i, j, k);
    a_a += a(i, j, k) * of_a(i, j, k);
  });
  EXPECT_GT(positive, 0);
  // Sums of 1e4 products in single precision.
  EXPECT_NEAR(domain.comm().sum(a_a), positive, 1e-5 * positive);
  EXPECT_NEAR(domain.comm().sum(a_b), domain.comm().sum(b_a), 1e-5 * positive);
}

INSTANTIATE_TEST_SUITE_P(shared_grids, gas_pressure_multigrid, testing::ValuesIn(shared_grids),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace gasgrain::pressure_cases
