// The void-fraction methods for cells smaller than particles: the kernel against transforms and
// Bessel functions, the particle grid against a coarse grid, both in a dense packing.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "coupling/exchange/void_fraction/choose_method.h"
#include "tests/random_packing.h"

namespace gasgrain {
namespace {

// Round-off of a sum of some hundred terms, and what the kernel is cut off at.
constexpr double round_off = 1e-13;

BoxGrid cube(int cells, double spacing, bool periodic) {
  BoxGrid grid;
  grid.hi = Vec3::Constant(cells * spacing);
  grid.cells = {cells, cells, cells};
  grid.periodic = {periodic, periodic, periodic};
  return grid;
}

Array3<double> deposited(const Cloud& cloud, const VoidFractionMethod& method,
                         const TileFrame& frame) {
  ParticleWeights weights;
  weights.find(cloud.view(), method, frame);
  Array3<double> field(frame.tile);
  weights.deposit([](std::size_t) { return 1.0; }, field);
  return field;
}

// --- the heat kernel --------------------------------------------------------------------------

TEST(heat_kernel, is_the_bessel_function_times_an_exponential) {
  for (const double tau : {1e-9, 1e-3, 0.2, 1.0, 7.0, 40.0, 400.0}) {
    const auto u = heat_kernel(tau);
    double sum = u[0];
    double variance = 0.0;
    for (std::size_t n = 0; n < u.size(); ++n) {
      const auto order = static_cast<double>(n);
      EXPECT_NEAR(u[n], std::exp(-tau) * std::cyl_bessel_i(order, tau), round_off) << tau;
      if (n == 0) continue;
      sum += 2.0 * u[n];
      variance += 2.0 * order * order * u[n];
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    EXPECT_NEAR(variance, tau, 1e-10 * std::max(tau, 1.0));
  }
  EXPECT_EQ(heat_kernel(0.0), std::vector<double>{1.0});
}

// --- the kernel -------------------------------------------------------------------------------

// A kernel whose exchange goes on until the variance is tau cells squared.
VoidFractionKernel kernel_of(double tau, double spacing) {
  return {1.0, std::sqrt(2.0 * (tau + 1.0 / 6.0)) * spacing};
}

// exp(tau L) of n cells between walls, by the cosine transform there and back.
Eigen::MatrixXd between_walls(int n, double tau) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (int q = 0; q < n; ++q) {
    Eigen::VectorXd wave(n);
    for (int i = 0; i < n; ++i) wave[i] = std::cos(pi * q * (i + 0.5) / n);
    sum += std::exp(-tau * (1.0 - std::cos(pi * q / n))) * wave * wave.transpose() /
           wave.squaredNorm();
  }
  return sum;
}

TEST(void_fraction_kernel, between_walls_is_a_cosine_transform_there_and_back) {
  for (const int n : {1, 2, 3, 4, 5, 6, 40})
    for (const double tau : {0.1, 1.0, 20.0, 300.0}) {
      const BoxGrid grid = cube(n, 0.3, false);
      const AxisSpread spread = kernel_of(tau, 0.3).spread(grid, 1, 0.0, {0, n});
      ASSERT_EQ(spread.outer.lo, 0);
      ASSERT_EQ(spread.outer.hi, n);
      EXPECT_LT((spread.share - between_walls(n, tau)).cwiseAbs().maxCoeff(), round_off);
      EXPECT_LT((spread.share - spread.share.transpose()).cwiseAbs().maxCoeff(), 1e-15);
    }
}

TEST(void_fraction_kernel, across_periodic_sides_is_a_fourier_transform_there_and_back) {
  for (const int n : {1, 2, 3, 4, 7, 40})
    for (const double tau : {0.1, 1.0, 20.0, 300.0}) {
      const BoxGrid grid = cube(n, 0.3, true);
      const VoidFractionKernel kernel = kernel_of(tau, 0.3);
      EXPECT_LE(kernel.reach(grid, 0, 0.0), 1 + n / 2) << "a tile need not hold a cell twice";
      const AxisSpread spread = kernel.spread(grid, 0, 0.0, {0, n});
      Eigen::MatrixXd wrapped = Eigen::MatrixXd::Zero(n, n);
      for (int cell = spread.outer.lo; cell < spread.outer.hi; ++cell)
        wrapped.row(((cell % n) + n) % n) += spread.share.row(cell - spread.outer.lo);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double expected = 0.0;
          for (int q = 0; q < n; ++q)
            expected += std::exp(-tau * (1.0 - std::cos(2.0 * pi * q / n))) *
                        std::cos(2.0 * pi * q * (i - j) / n) / n;
          EXPECT_NEAR(wrapped(i, j), expected, round_off);
        }
    }
}

// Cells of 1 x 0.4 x 2.3 mm, and the bell is 4 mm wide along each axis.
TEST(void_fraction_kernel, has_the_same_width_in_metres_along_axes_of_unequal_cells) {
  BoxGrid grid;
  grid.hi = {0.08, 0.08, 0.0805};
  grid.cells = {80, 200, 35};
  const double b = 4e-3;
  const VoidFractionKernel kernel{2.0, 0.5 * b};
  Vec3 variance = Vec3::Zero();
  const int places = 8;  // within a cell: there the trilinear part differs
  for (int place = 0; place < places; ++place) {
    const Vec3 x = 0.5 * grid.hi + (place + 0.5) / places * grid.spacing();
    Cloud cloud;
    cloud.add(x, Vec3::Zero(), 0.25 * b);
    const Array3<double> field = deposited(cloud, kernel, {grid, grid.all()});
    for_each_cell(grid.all(), [&](int i, int j, int k) {
      const Vec3 centre = grid.spacing().cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
      variance += field(i, j, k) * (centre - x).cwiseAbs2() / places;
    });
  }
  // Eight places make the mean of f (1 - f) 0.1680, not 1/6.
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(variance[d] / (0.5 * b * b), 1.0, 1e-3) << "axis " << d;
}

TEST(void_fraction_kernel, is_trilinear_weighting_once_cells_are_wide) {
  Random random(1);
  const BoxGrid grid = uneven_box({true, false, true});
  const Cloud cloud = random_cloud(grid, 100, random);
  const double width = grid.spacing().minCoeff() / std::sqrt(3.0) / (2.0 * cloud_radius);
  const VoidFractionKernel kernel{0.999 * width, 2.0 * cloud_radius};
  const TileFrame frame = whole_frame(grid, kernel);
  const Array3<double> field = wrapped(deposited(cloud, kernel, frame), grid);
  const Array3<double> trilinear = wrapped(deposited(cloud, VoidFractionTrilinear{}, frame), grid);
  for (std::size_t n = 0; n < field.size(); ++n) EXPECT_NEAR(field[n], trilinear[n], 1e-14);
}

// --- the particle grid ------------------------------------------------------------------------

TEST(axis_blocks, cover_the_cells_in_order_none_narrower_than_asked) {
  for (int cells = 1; cells <= 40; ++cells)
    for (int least = 1; least <= cells; ++least) {
      const AxisBlocks blocks(cells, least);
      EXPECT_EQ(blocks.first_cell(0), 0);
      EXPECT_EQ(blocks.first_cell(blocks.blocks), cells);
      for (int b = -2 * blocks.blocks; b < 2 * blocks.blocks; ++b) {
        const int from = blocks.first_cell(b);
        const int to = blocks.first_cell(b + 1);
        EXPECT_GE(to - from, least);
        EXPECT_LE(to - from, blocks.greatest());
        for (int c = from; c < to; ++c) EXPECT_EQ(blocks.block_of(c), b);
      }
    }
}

// 12 x 12 x 12 cells in blocks of three, against trilinear weighting on 4 x 4 x 4.
TEST(void_fraction_particle_grid, is_trilinear_weighting_on_the_grid_of_blocks) {
  for (const bool periodic : {false, true}) {
    const BoxGrid fine = cube(12, 1e-3, periodic);
    BoxGrid coarse = fine;
    coarse.cells = {4, 4, 4};
    const VoidFractionParticleGrid method{2.5, 1.2e-3};
    Random random(2);
    const Cloud cloud = random_cloud(fine, 200, random);
    const TileFrame frame{fine, periodic ? fine.all().grown(6) : fine.all()};
    const TileFrame blocks{coarse, periodic ? coarse.all().grown(2) : coarse.all()};
    const Array3<double> field = deposited(cloud, method, frame);
    const Array3<double> on_blocks = deposited(cloud, VoidFractionTrilinear{}, blocks);
    for_each_cell(frame.tile, [&](int i, int j, int k) {
      const auto block = [](int c) { return (c + 300) / 3 - 100; };
      EXPECT_NEAR(field(i, j, k), on_blocks(block(i), block(j), block(k)) / 27.0, 1e-12);
    });
  }
}

// 7 cells in blocks of 2, 2 and 3: particles evenly along an axis fill them evenly.
TEST(void_fraction_particle_grid, keeps_an_even_suspension_even_where_blocks_are_not_equal) {
  for (const bool periodic : {false, true}) {
    BoxGrid grid = cube(7, 1.0, periodic);
    const VoidFractionParticleGrid method{2.0, 1.0};
    const int per_cell = 50;
    Cloud cloud;
    for (int n = 0; n < 7 * per_cell; ++n)
      cloud.add(Vec3((n + 0.5) / per_cell, 3.3, 3.4), Vec3::Zero(), 0.5);
    const TileFrame frame = whole_frame(grid, method, 0.5);
    const Array3<double> field = deposited(cloud, method, frame);
    std::vector<double> along_x(7, 0.0);
    for_each_cell(frame.tile,
                  [&](int i, int j, int k) { along_x[(i + 70) % 7] += field(i, j, k); });
    for (const double sum : along_x) EXPECT_NEAR(sum / per_cell, 1.0, 1e-12);
  }
}

// --- offset -----------------------------------------------------------------------------------

TEST(void_fraction_offset, is_the_mean_of_centre_over_all_displacements) {
  const BoxGrid grid = uneven_box({true, false, true});
  for (const double radius : {0.4, 1.3}) {
    const double r = radius * grid.spacing().minCoeff();
    const Vec3 x = grid.lo + Vec3(2.3, 0.4, 3.1).cwiseProduct(grid.spacing());
    Cloud one;
    one.add(x, Vec3::Zero(), r);
    const int n = 40;
    Cloud displaced;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
          displaced.add(x + r * Vec3((2 * i + 1.0) / n - 1.0, (2 * j + 1.0) / n - 1.0,
                                     (2 * k + 1.0) / n - 1.0),
                        Vec3::Zero(), r);
    const TileFrame frame = whole_frame(grid, VoidFractionOffset{}, r);
    const Array3<double> offset = deposited(one, VoidFractionOffset{}, frame);
    const Array3<double> centre = deposited(displaced, VoidFractionCentre{}, frame);
    // Of 40 points along an axis one may be on either side of a face.
    for (std::size_t c = 0; c < offset.size(); ++c)
      EXPECT_NEAR(offset[c], centre[c] / (n * n * n), 1.5 / n);
  }
}

// --- dense packings ---------------------------------------------------------------------------

// d = 0.2, 1, 2 and 5 cells: eps stays far from nothing, and the solids are all there.
TEST(void_fraction_of_a_dense_packing, is_that_of_a_bed_at_any_size_of_cells) {
  Random random(7);
  const double side = 10.0;
  const auto points = random_packing(0.58, side, random);
  Cloud cloud;
  for (const Vec3& x : points) cloud.add(x, Vec3::Zero(), 0.5);
  const double solids = static_cast<double>(points.size()) * sphere_volume(0.5);
  for (const int cells : {2, 10, 20, 50}) {
    const BoxGrid grid = cube(cells, side / cells, true);
    for (const VoidFractionMethod& method :
         {VoidFractionMethod(VoidFractionKernel{}), VoidFractionMethod(VoidFractionParticleGrid{}),
          VoidFractionMethod(VoidFractionExact{})}) {
      const TileFrame frame = whole_frame(grid, method, 0.5);
      ParticleWeights weights;
      weights.find(cloud.view(), method, frame);
      Array3<double> field(frame.tile);
      deposit_solid_volume(cloud.view(), weights, field);
      EXPECT_NEAR(std::accumulate(field.begin(), field.end(), 0.0) / solids, 1.0, 1e-12);
      Array3<double> eps(grid.all(), 1.0);
      for_each_cell(frame.tile, [&](int i, int j, int k) {
        const auto wrap = [cells](int a) { return ((a % cells) + cells) % cells; };
        eps(wrap(i), wrap(j), wrap(k)) -= field(i, j, k) / grid.cell_volume();
      });
      const bool exact = std::holds_alternative<VoidFractionExact>(method);
      for (const double value : eps) {
        EXPECT_GE(value, exact ? -1e-12 : 0.35) << name_of(method) << ", " << cells << " cells";
        EXPECT_LE(value, exact ? 1.0 + 1e-12 : 0.5) << name_of(method) << ", " << cells << " cells";
      }
    }
  }
}

// --- which one --------------------------------------------------------------------------------

TEST(choose_method, takes_the_kernel_where_a_cell_is_too_small_to_average_over) {
  const double radius = 0.5e-3;
  const auto name = [&](double spacing) {
    return name_of(choose_method(radius, radius, cube(10, spacing, false)).method);
  };
  EXPECT_EQ(name(5e-3), "trilinear");
  EXPECT_EQ(name(3.5e-3), "trilinear");
  EXPECT_EQ(name(3.4e-3), "kernel");
  EXPECT_EQ(name(0.2e-3), "kernel");
  BoxGrid slab = cube(10, 5e-3, false);
  slab.cells[1] = 30;
  EXPECT_EQ(name_of(choose_method(radius, radius, slab).method), "kernel") << "the least axis";
}

TEST(choose_method, gives_its_reason_and_says_what_was_not_measured) {
  const auto reason = [](double smallest, double spacing) {
    return choose_method(smallest, 1.25e-3, cube(10, spacing, false)).reason;
  };
  EXPECT_EQ(reason(1.25e-3, 10e-3),
            "void_fraction auto: trilinear, for particles of 2.5 mm in cells of 10 x 10 x 10 mm: a "
            "cell is 4 diameters wide or more, enough to average over");
  EXPECT_EQ(reason(1e-3, 1e-3),
            "void_fraction auto: kernel 2, for particles of 2 to 2.5 mm in cells of 1 x 1 x 1 mm: "
            "a cell is only 0.4 diameters wide, and the void fraction is taken over 2 diameters "
            "about each particle");
  EXPECT_NE(reason(1e-3, 0.25e-3).find("10 cells across a particle"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain
