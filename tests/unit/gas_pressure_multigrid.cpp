// Iterations of the multigrid against the fineness, the spacing and the contrast of a bed.
#include <gtest/gtest.h>

#include "gas_solver/pressure/pressure_solver.h"
#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using gas_cases::scatter;

constexpr Sides below_an_outlet{&wall_no_slip, &wall_no_slip, &wall_no_slip,
                                &wall_no_slip, &wall_no_slip, &outlet};

// To 1e-8, in a unit box of cells whose coefficients are 1 in a bubble and in the upper half, and
// 1 / contrast with a scatter of 10 % in the bed below.
int iterations(const Int3& cells, double contrast) {
  BoxGrid grid;
  grid.cells = cells;
  const Domain domain(grid, gas_cases::self());
  const Vec3 h = grid.spacing();
  PressureSystem system(domain, below_an_outlet);
  const auto mobility = [&](int i, int j, int k) {
    const Vec3 x((i + 0.5) * h[0], (j + 0.5) * h[1], (k + 0.5) * h[2]);
    if (x[2] > 0.5 || (x - Vec3(0.4, 0.5, 0.25)).norm() < 0.15) return 1.0;
    return (0.95 + 0.1 * scatter(i, j, k)) / contrast;
  };
  for (int d = 0; d < 3; ++d) {
    for_each_cell(domain.faces(d), [&](int i, int j, int k) {
      Int3 low{i, j, k};
      --low[d];
      system.face_coefficient[d](i, j, k) =
          0.5 * (mobility(i, j, k) + mobility(low[0], low[1], low[2])) / (h[d] * h[d]);
    });
    for (const bool high : {false, true}) {
      const int side = side_of(d, high);
      const double factor = below_an_outlet[side]->normal_velocity_given ? 0.0 : 2.0;
      for_each_cell(domain.side_faces(side),
                    [&](int i, int j, int k) { system.face_coefficient[d](i, j, k) *= factor; });
    }
  }
  double square = 0;
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    system.source(i, j, k) = scatter(k, i, j) - 0.5;
    square += system.source(i, j, k) * system.source(i, j, k);
  });
  return PressureSolver(domain, PressureMethod::multigrid).solve(system, 1e-8 * std::sqrt(square));
}

TEST(gas_pressure_multigrid_cost, iterations_hardly_grow_with_the_cells) {
  const int coarse = iterations({12, 12, 12}, 24);
  EXPECT_LE(coarse, 16);
  EXPECT_LE(iterations({24, 24, 24}, 24), coarse + 3);
  EXPECT_LE(iterations({48, 48, 48}, 24), coarse + 5);
}

// Coarsening along the closely spaced axes first keeps those of a grid of cubes; what is left of
// the growth are axes with ratios of spacing between 1 and 2.
TEST(gas_pressure_multigrid_cost, iterations_bear_unequal_spacing) {
  const int equal = iterations({24, 24, 24}, 24);
  for (const Int3& cells : {Int3{96, 12, 12}, Int3{12, 96, 12}, Int3{12, 12, 96}, Int3{64, 64, 4},
                            Int3{8, 64, 64}, Int3{64, 8, 24}})
    EXPECT_LE(iterations(cells, 24), 2 * equal)
        << cells[0] << " x " << cells[1] << " x " << cells[2];
}

TEST(gas_pressure_multigrid_cost, iterations_bear_the_contrast_of_a_bubble) {
  EXPECT_LE(iterations({24, 24, 24}, 650), 25);
  EXPECT_LE(iterations({24, 24, 24}, 1e4), 35);
}

TEST(gas_pressure_multigrid_cost, grids_of_a_row_or_a_cell_are_solved) {
  for (const Int3& cells : {Int3{1, 1, 1}, Int3{40, 1, 1}, Int3{1, 40, 1}, Int3{1, 1, 40}})
    EXPECT_LE(iterations(cells, 24), 25) << cells[0] << " x " << cells[1] << " x " << cells[2];
}

}  // namespace
}  // namespace gasgrain
