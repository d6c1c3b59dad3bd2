// The exact void fraction, against integration that knows nothing of its formulas, against known
// special cases, and where other methods give up: spheres greater than cells.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

const double whole = 4.0 / 3.0 * pi;  // the unit sphere's volume
// Of the sphere's volume: round-off of eight corners, each of some ten terms of order 1. What is
// asked of the method is 1e-12.
constexpr double round_off = 1e-14;

// --- integration ------------------------------------------------------------------------------

struct GaussRule {
  static constexpr int points = 24;
  std::array<double, points> node{};
  std::array<double, points> weight{};

  GaussRule() {
    for (int i = 0; i < points; ++i) {
      double t = std::cos(pi * (i + 0.75) / (points + 0.5));
      double slope = 1.0;
      for (int newton = 0; newton < 50; ++newton) {
        double before = 1.0;
        double value = t;
        for (int n = 2; n <= points; ++n) {
          const double next = ((2 * n - 1) * t * value - (n - 1) * before) / n;
          before = value;
          value = next;
        }
        slope = points * (t * value - before) / (t * t - 1.0);
        t -= value / slope;
      }
      node[i] = t;
      weight[i] = 2.0 / ((1.0 - t * t) * slope * slope);
    }
  }
};

// Between two breaks the integrand is smooth, but may end in square roots. With t -> (3t - t^3)/2,
// flat at both ends, those are smooth too. Pieces grow away from the breaks, for there may be
// another root close beyond.
template <class F>
double integral(std::vector<double> breaks, double low, double high, F&& f) {
  static const GaussRule rule;
  breaks.push_back(low);
  breaks.push_back(high);
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t n = 0; n + 1 < breaks.size(); ++n) {
    const double a = std::clamp(breaks[n], low, high);
    const double b = std::clamp(breaks[n + 1], low, high);
    if (b - a <= 0.0) continue;
    constexpr std::array<double, 7> pieces{0.0, 0.005, 0.07, 0.5, 0.93, 0.995, 1.0};
    for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
      const double half = 0.5 * (b - a) * (pieces[piece + 1] - pieces[piece]);
      const double middle = a + 0.5 * (b - a) * (pieces[piece + 1] + pieces[piece]);
      for (int i = 0; i < GaussRule::points; ++i) {
        const double t = rule.node[i];
        const double at = middle + half * 0.5 * t * (3.0 - t * t);
        sum += half * 1.5 * (1.0 - t * t) * rule.weight[i] * f(at);
      }
    }
  }
  return sum;
}

double root(double square) {
  return std::sqrt(std::max(0.0, square));
}

// Chords along z, clipped by the box, over y, over x.
double integrated_overlap(const Vec3& lo, const Vec3& hi) {
  std::vector<double> breaks_x{-1.0, 0.0, 1.0};
  const auto both = [](std::vector<double>& breaks, double square) {
    breaks.push_back(root(square));
    breaks.push_back(-root(square));
  };
  for (const double y : {lo[1], hi[1]}) both(breaks_x, 1.0 - y * y);
  for (const double z : {lo[2], hi[2]}) both(breaks_x, 1.0 - z * z);
  for (const double y : {lo[1], hi[1]})
    for (const double z : {lo[2], hi[2]}) both(breaks_x, 1.0 - y * y - z * z);
  return integral(breaks_x, lo[0], hi[0], [&](double x) {
    const double square = 1.0 - x * x;
    if (square <= 0.0) return 0.0;
    std::vector<double> breaks_y;
    both(breaks_y, square);
    for (const double z : {lo[2], hi[2]}) both(breaks_y, square - z * z);
    return integral(breaks_y, lo[1], hi[1], [&](double y) {
      const double half = root(square - y * y);
      return std::max(0.0, std::min(hi[2], half) - std::max(lo[2], -half));
    });
  });
}

TEST(sphere_box_overlap, agrees_with_integration_for_random_boxes) {
  Random random(1);
  double greatest = 0.0;
  for (int n = 0; n < 300; ++n) {
    // Of every size from a hundredth of the sphere to thrice it.
    const double size = std::pow(10.0, random.between(-2.0, 0.5));
    const Vec3 centre = random.vector(1.2);
    const Vec3 half = size * random.vector(Vec3::Constant(0.05), Vec3::Constant(1.0));
    const Vec3 lo = centre - half;
    const Vec3 hi = centre + half;
    const double error = std::abs(sphere_box_overlap(lo, hi) - integrated_overlap(lo, hi)) / whole;
    greatest = std::max(greatest, error);
    EXPECT_LT(error, 1e-12) << "box (" << lo.transpose() << ") to (" << hi.transpose() << ")";
  }
  RecordProperty("greatest_error", fmt::format("{:g}", greatest));
}

TEST(sphere_box_overlap, agrees_with_integration_for_boxes_that_almost_miss_almost_fit_or_align) {
  const double corner = 1.0 / std::sqrt(3.0);
  const double edge = 1.0 / std::sqrt(2.0);
  for (const double slip : {0.0, 1e-15, 1e-12, 1e-8, 1e-4})
    for (const double sign : {-1.0, 1.0}) {
      const double e = sign * slip;
      for (const Vec3& lo : {Vec3(corner + e, corner + e, corner + e), Vec3(edge + e, edge, -0.3),
                             Vec3(1.0 + e, 0.0, 0.0), Vec3(e, e, e), Vec3(e, 1.0 - slip, -1.0)})
        for (const double size : {1e-6, 0.3, 2.5}) {
          const Vec3 hi = lo + Vec3::Constant(size);
          EXPECT_NEAR(sphere_box_overlap(lo, hi) / whole, integrated_overlap(lo, hi) / whole, 1e-12)
              << "box from (" << lo.transpose() << ") of size " << size;
        }
    }
}

// --- special cases ----------------------------------------------------------------------------

TEST(sphere_box_overlap, is_a_cap_a_half_a_quarter_and_an_octant) {
  const double far = 7.0;
  for (const double a : {-1.0, -0.999, -0.4, 0.0, 0.3, 0.9, 1.0 - 1e-9, 1.0}) {
    const double cap = pi / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a);
    for (int d = 0; d < 3; ++d) {
      Vec3 lo = Vec3::Constant(-far);
      lo[d] = a;
      EXPECT_NEAR(sphere_box_overlap(lo, Vec3::Constant(far)) / whole, cap / whole, round_off);
    }
  }
  EXPECT_NEAR(sphere_box_overlap({0, -far, -far}, Vec3::Constant(far)), whole / 2, round_off);
  EXPECT_NEAR(sphere_box_overlap({0, 0, -far}, Vec3::Constant(far)), whole / 4, round_off);
  EXPECT_NEAR(sphere_box_overlap({0, 0, 0}, Vec3::Constant(far)), whole / 8, round_off);
}

TEST(sphere_box_overlap, is_the_box_inside_the_sphere_and_the_sphere_inside_the_box) {
  const Vec3 lo(-0.2, -0.31, 0.1);
  const Vec3 hi(0.5, 0.25, 0.55);
  EXPECT_NEAR(sphere_box_overlap(lo, hi), (hi - lo).prod(), round_off);
  EXPECT_NEAR(sphere_box_overlap(Vec3(-1.0, -3.0, -1.5), Vec3(1.0, 1.0, 2.0)), whole, 5e-15);
  EXPECT_EQ(sphere_box_overlap(Vec3(1.0, -3.0, -1.5), Vec3(2.0, 1.0, 2.0)), 0.0);
}

TEST(sphere_box_overlap, is_the_sphere_less_six_caps_for_a_concentric_cube) {
  for (const double a : {0.71, 0.8, 0.95}) {  // half an edge; the caps do not meet
    const double cap = pi / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a);
    EXPECT_NEAR(sphere_box_overlap(Vec3::Constant(-a), Vec3::Constant(a)) / whole,
                1.0 - 6.0 * cap / whole, round_off);
  }
}

// --- the method -------------------------------------------------------------------------------

std::map<Int3, double> weights_of(const TileFrame& frame, const Vec3& x, double radius) {
  std::map<Int3, double> weights;
  VoidFractionExact::for_each_weight(frame, x, radius, [&](int i, int j, int k, double w) {
    EXPECT_GT(w, 0.0);
    EXPECT_TRUE(weights.emplace(Int3{i, j, k}, w).second) << "a cell is named twice";
  });
  return weights;
}

double sum_of(const std::map<Int3, double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0,
                         [](double sum, const auto& entry) { return sum + entry.second; });
}

// Unequal cells, a sphere of up to 20 of them across.
TEST(void_fraction_exact, gives_spheres_of_any_size_weights_of_their_overlaps) {
  const BoxGrid grid = uneven_box({true, true, true});
  const TileFrame frame{grid, grid.all()};
  const Vec3 h = grid.spacing();
  Random random(3);
  for (const double diameter_in_cells : {0.01, 0.3, 0.99, 2.0, 5.0, 20.0})
    for (int n = 0; n < 20; ++n) {
      const double radius = 0.5 * diameter_in_cells * h.minCoeff();
      const Vec3 x = random.vector(grid.lo, grid.hi);
      const auto weights = weights_of(frame, x, radius);
      EXPECT_NEAR(sum_of(weights), 1.0, 1e-13);
      for (const auto& [cell, w] : weights) {
        const Vec3 lo = grid.lo + h.cwiseProduct(Vec3(cell[0], cell[1], cell[2])) - x;
        const double overlap = sphere_box_overlap(lo / radius, (lo + h) / radius) / whole;
        // The position's own rounding, in radii.
        EXPECT_NEAR(w, overlap, 1e-14 + 1e-15 * grid.hi.maxCoeff() / radius);
      }
    }
}

// A sphere wider than the box, one out of a corner, one wholly outside of it.
TEST(void_fraction_exact, gives_what_lies_beyond_walls_to_the_cells_at_them) {
  const BoxGrid grid = uneven_box({false, false, false});
  const TileFrame frame{grid, grid.all()};
  const Vec3 h = grid.spacing();
  for (const double radius : {0.3 * h[0], h[0], 10.0 * h[0]})
    for (const Vec3& x : {grid.lo, grid.hi, Vec3(0.5 * (grid.lo + grid.hi)),
                          Vec3(grid.lo - Vec3::Constant(radius)), Vec3(grid.hi + 30.0 * h)}) {
      const auto weights = weights_of(frame, x, radius);
      EXPECT_NEAR(sum_of(weights), 1.0, 1e-13);
      for (const auto& entry : weights) {
        const Int3& cell = entry.first;
        EXPECT_TRUE(frame.tile.contains(cell[0], cell[1], cell[2]));
      }
    }
  // Centred on a face's wall: the half beyond it joins the half within.
  const Vec3 x(grid.lo[0], grid.lo[1] + 0.5 * h[1], grid.lo[2] + 0.5 * h[2]);
  EXPECT_EQ(weights_of(frame, x, 0.3 * h.minCoeff()), (std::map<Int3, double>{{{0, 0, 0}, 1.0}}));
}

// Each cell beyond a wall, were there any, would hand its share to the nearest cell of the box.
TEST(void_fraction_exact, folds_at_walls_what_an_endless_grid_would_have_beyond) {
  const BoxGrid walled = uneven_box({false, false, false});
  const BoxGrid endless = uneven_box({true, true, true});
  Random random(6);
  for (int n = 0; n < 200; ++n) {
    const double radius = random.between(0.1, 3.0) * walled.spacing().minCoeff();
    const Vec3 x = random.vector(walled.lo, walled.hi);
    std::map<Int3, double> folded;
    for (const auto& entry : weights_of({endless, endless.all()}, x, radius)) {
      Int3 cell = entry.first;
      for (int d = 0; d < 3; ++d) cell[d] = std::clamp(cell[d], 0, walled.cells[d] - 1);
      folded[cell] += entry.second;
    }
    for (const auto& [cell, w] : weights_of({walled, walled.all()}, x, radius)) folded[cell] -= w;
    for (const auto& entry : folded) EXPECT_NEAR(entry.second, 0.0, round_off);
  }
}

// A movement by a millionth of a radius moves no more than the greatest disc times that, for a
// sphere of five cells across faces, edges and corners.
TEST(void_fraction_exact, is_continuous_for_spheres_greater_than_cells) {
  const BoxGrid grid = uneven_box({false, true, false});
  const TileFrame frame{grid, grid.all()};
  const double radius = 2.5 * grid.spacing().minCoeff();
  const Vec3 step = 1e-6 * radius * Vec3(1.0, 1.0, 1.0).normalized();
  Random random(4);
  for (int n = 0; n < 200; ++n) {
    Vec3 x = random.vector(grid.lo, grid.hi);
    if (n % 2 == 0)  // a face of the grid touches the sphere, or is half a step off
      for (int d = 0; d < 3; ++d)
        x[d] = grid.lo[d] + grid.cell_of(x[d], d) * grid.spacing()[d] + radius - 0.5 * step[d];
    auto change = weights_of(frame, x + step, radius);
    for (const auto& [cell, w] : weights_of(frame, x, radius)) change[cell] -= w;
    for (const auto& entry : change) EXPECT_LT(std::abs(entry.second), 0.75 * 2e-6);
  }
}

TEST(void_fraction_exact, keeps_the_solid_volume_of_mixed_sizes) {
  const BoxGrid grid = uneven_box({false, false, false});
  const TileFrame frame{grid, grid.all()};
  Random random(5);
  Cloud cloud;
  double expected = 0.0;
  for (int n = 0; n < 500; ++n) {
    cloud.add(random.vector(grid.lo, grid.hi), Vec3::Zero(),
              grid.spacing()[1] * std::pow(10.0, random.between(-2.0, 0.5)));
    expected += sphere_volume(cloud.radius.back());
  }
  ParticleWeights weights;
  weights.find(cloud.view(), VoidFractionExact{}, frame);
  Array3<double> solids(frame.tile);
  deposit_solid_volume(cloud.view(), weights, solids);
  EXPECT_NEAR(std::accumulate(solids.begin(), solids.end(), 0.0) / expected, 1.0, 1e-12);
}

}  // namespace
}  // namespace gasgrain
