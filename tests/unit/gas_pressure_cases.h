// Pressure systems whose coefficients depend on the cell's place alone, so that any number of ranks
// poses the same one, and the tests that one, two and four ranks share.
#pragma once

#include <gtest/gtest.h>

#include "gas_solver/grid/halo.h"
#include "gas_solver/pressure/pressure_solver.h"
#include "tests/gas_cases.h"

namespace gasgrain::pressure_cases {

struct Case {
  const char* name;
  Int3 cells;
  Sides sides;
  int layered_along;  // axis; -1: every coefficient differs
  bool storage;
};

inline void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

inline constexpr const BoundaryKind* wall = &wall_no_slip;
inline constexpr const BoundaryKind* open = &outlet;
inline constexpr const BoundaryKind* around = &periodic_side;

inline const std::vector<Case> cases{
    {"layers_along_z", {6, 4, 10}, {wall, wall, wall, wall, wall, open}, 2, false},
    {"layers_along_x", {9, 4, 6}, {open, open, wall, wall, wall, wall}, 0, false},
    {"layers_along_y", {4, 10, 5}, {wall, wall, wall, open, around, around}, 1, false},
    {"layers_and_storage", {6, 5, 9}, {wall, wall, around, around, wall, open}, 2, true},
    {"fewer_layers_than_ranks", {16, 8, 3}, {wall, wall, wall, wall, open, open}, 2, false},
    {"one_layer", {8, 8, 1}, {wall, wall, wall, wall, wall, open}, 2, false},
    {"layers_round_periodic_axes",
     {6, 4, 8},
     {around, around, around, around, around, around},
     2,
     false},
    {"two_layers_round_a_periodic_axis",
     {16, 4, 2},
     {wall, wall, wall, wall, around, around},
     2,
     false},
    {"sealed_layers", {6, 5, 8}, gas_cases::walls, 2, false},
    {"sealed_layers_with_storage", {6, 5, 8}, gas_cases::walls, 2, true},
    {"one_cell_deep", {12, 1, 10}, {wall, wall, around, around, wall, open}, 2, false},
    {"bed", {8, 6, 12}, {wall, wall, wall, wall, wall, open}, -1, false},
    {"bed_one_cell_deep", {12, 1, 10}, {wall, wall, wall, wall, wall, open}, -1, false},
    {"bed_one_cell_round", {12, 1, 10}, {wall, wall, around, around, wall, open}, -1, false},
    {"bed_between_periodic_sides",
     {9, 6, 8},
     {around, around, around, around, wall, open},
     -1,
     false},
    {"bed_with_storage", {8, 6, 12}, {wall, wall, wall, wall, wall, open}, -1, true},
    {"bed_of_four_layers_round_an_axis",
     {16, 4, 4},
     {wall, wall, wall, wall, around, around},
     -1,
     false},
    {"sealed_bed", {8, 6, 10}, gas_cases::walls, -1, false},
    {"sealed_bed_with_storage", {8, 6, 10}, gas_cases::walls, -1, true},
    {"periodic_bed", {8, 6, 10}, {around, around, around, around, around, around}, -1, false},
};

inline BoxGrid grid_of(const Case& c) {
  BoxGrid grid;
  grid.cells = c.cells;
  for (int d = 0; d < 3; ++d) grid.periodic[d] = c.sides[side_of(d, false)]->periodic;
  return grid;
}

// The system of a step; later steps have somewhat other coefficients and sources.
inline PressureSystem posed(const Case& c, const Domain& domain, int step = 0) {
  using gas_cases::scatter;
  PressureSystem system(domain, c.sides);
  const auto place = [&](Int3 at) {  // what a coefficient depends on
    for (int d = 0; d < 3; ++d) {
      at[d] %= c.cells[d] + (c.sides[side_of(d, false)]->periodic ? 0 : 1);
      if (c.layered_along >= 0 && d != c.layered_along) at[d] = 0;
    }
    return at;
  };
  for (int d = 0; d < 3; ++d) {
    const bool alone = domain.grid().periodic[d] && c.cells[d] == 1;
    IndexBox faces = domain.own();
    ++faces.hi[d];
    for_each_cell(faces, [&](int i, int j, int k) {
      const Int3 at = place({i, j, k});
      const double value = 0.1 + scatter(at[0] + 31 * d, at[1], at[2]) + 0.01 * step;
      system.face_coefficient[d](i, j, k) = alone ? 0.0 : value;
    });
    for (const bool high : {false, true}) {
      const int side = side_of(d, high);
      const double factor = c.sides[side]->normal_velocity_given ? 0.0 : 2.0;
      for_each_cell(domain.side_faces(side),
                    [&](int i, int j, int k) { system.face_coefficient[d](i, j, k) *= factor; });
    }
  }
  if (c.storage) {
    system.storage = Array3<double>(domain.own());
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      const Int3 at = place({i, j, k});
      system.storage(i, j, k) = 0.2 * scatter(at[1], at[2], at[0]);
    });
  }
  system.singular = !c.storage;
  for (int side = 0; side < side_count; ++side)
    if (c.sides[side] == open) system.singular = false;
  double sum = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    system.source(i, j, k) = scatter(k + step, i, j) - 0.3;
    sum += system.source(i, j, k);
  });
  if (system.singular) {
    const double mean = domain.comm().sum(sum) / static_cast<double>(domain.grid().all().size());
    for (double& value : system.source) value -= mean;
  }
  return system;
}

inline double norm(const Domain& domain, const Array3<double>& cells) {
  double sum = 0;
  for (const double value : cells) sum += value * value;
  return std::sqrt(domain.comm().sum(sum));
}

// Source less matrix times solution, as pressure_system.h defines them.
inline Array3<double> residual(const Domain& domain, PressureSystem& system) {
  Halo halo(domain);
  Array3<double> x(domain.box());  // 0 beyond the domain
  for_each_cell(domain.own(), [&](int i, int j, int k) { x(i, j, k) = system.solution(i, j, k); });
  halo.exchange({&x});
  Array3<double> rest = system.source;
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    double& r = rest(i, j, k);
    const auto o = x.offset(i, j, k);
    if (system.storage.size() > 0) r -= system.storage(i, j, k) * x[o];
    for (int d = 0; d < 3; ++d) {
      const Array3<double>& c = system.face_coefficient[d];
      const auto s = x.stride(d);
      r -= c[o] * (x[o] - x[o - s]) + c[o + s] * (x[o] - x[o + s]);
    }
  });
  return rest;
}

// The solution over the own cells, with the mean 0 where only differences are known.
inline Array3<double> solved(const Domain& domain, PressureSystem& system, PressureMethod method) {
  PressureSolver solver(domain, method);
  solver.solve(system, 1e-12 * norm(domain, system.source));
  // 1e-12, and the round-off of a direct solution.
  EXPECT_LE(norm(domain, residual(domain, system)), 1e-11 * norm(domain, system.source))
      << "method " << static_cast<int>(method);
  Array3<double> x(domain.own());
  double sum = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) { sum += system.solution(i, j, k); });
  const double mean = system.singular
                          ? domain.comm().sum(sum) / static_cast<double>(domain.grid().all().size())
                          : 0.0;
  for_each_cell(domain.own(),
                [&](int i, int j, int k) { x(i, j, k) = system.solution(i, j, k) - mean; });
  return x;
}

class gas_pressure_ranks : public testing::TestWithParam<Case> {};

TEST_P(gas_pressure_ranks, every_method_gives_what_hypre_gives_on_one_rank) {
  const Domain alone(grid_of(GetParam()), gas_cases::self());
  PressureSystem system = posed(GetParam(), alone);
  const Array3<double> expected = solved(alone, system, PressureMethod::hypre);
  double scale = 0;
  for (const double x : expected) scale = std::max(scale, std::abs(x));

  const Domain domain(grid_of(GetParam()), Communicator(MPI_COMM_WORLD));
  for (const auto method : {PressureMethod::fftw, PressureMethod::hypre, PressureMethod::multigrid,
                            PressureMethod::automatic}) {
    PressureSystem shared = posed(GetParam(), domain);
    const Array3<double> x = solved(domain, shared, method);
    // The matrices' condition is below 1e3, the residual 1e-12.
    for_each_cell(domain.own(), [&](int i, int j, int k) {
      ASSERT_NEAR(x(i, j, k), expected(i, j, k), 1e-9 * scale);
    });
  }
}

TEST_P(gas_pressure_ranks, layers_are_solved_directly_and_nothing_else_is) {
  const Domain domain(grid_of(GetParam()), Communicator(MPI_COMM_WORLD));
  PressureSystem system = posed(GetParam(), domain);
  PressureSolver solver(domain, PressureMethod::fftw);
  const int iterations = solver.solve(system, 1e-8 * norm(domain, system.source));
  EXPECT_EQ(iterations == 0, GetParam().layered_along >= 0) << iterations;
}

TEST_P(gas_pressure_ranks, the_whole_balances_at_a_coarse_tolerance) {
  const Domain domain(grid_of(GetParam()), Communicator(MPI_COMM_WORLD));
  for (const auto method : {PressureMethod::fftw, PressureMethod::hypre, PressureMethod::multigrid,
                            PressureMethod::automatic}) {
    PressureSystem system = posed(GetParam(), domain);
    const double tolerance = 1e-6 * norm(domain, system.source);
    PressureSolver(domain, method).solve(system, tolerance);
    const Array3<double> rest = residual(domain, system);
    EXPECT_LE(norm(domain, rest), 1.001 * tolerance);  // round-off of 1e-15 in 1e-12
    double sum = 0;
    double inflow = 0;
    for (const double value : rest) sum += value;
    for (const double value : system.source) inflow += std::max(value, 0.0);
    EXPECT_LE(std::abs(domain.comm().sum(sum)), 1e-12 * domain.comm().sum(inflow));
  }
}

TEST_P(gas_pressure_ranks, a_solver_that_forgot_is_a_new_one_bit_for_bit) {
  const Domain domain(grid_of(GetParam()), Communicator(MPI_COMM_WORLD));
  for (const auto method : {PressureMethod::hypre, PressureMethod::automatic}) {
    PressureSolver old(domain, method);
    for (int step = 0; step < 4; ++step) {
      PressureSystem system = posed(GetParam(), domain, step);
      old.solve(system, 1e-8 * norm(domain, system.source));
    }
    old.forget();
    PressureSolver fresh(domain, method);
    for (int step = 4; step < 8; ++step) {
      PressureSystem of_old = posed(GetParam(), domain, step);
      PressureSystem of_fresh = posed(GetParam(), domain, step);
      const double tolerance = 1e-8 * norm(domain, of_old.source);
      EXPECT_EQ(old.solve(of_old, tolerance), fresh.solve(of_fresh, tolerance));
      EXPECT_TRUE(
          std::equal(of_old.solution.begin(), of_old.solution.end(), of_fresh.solution.begin()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(cases, gas_pressure_ranks, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace gasgrain::pressure_cases
