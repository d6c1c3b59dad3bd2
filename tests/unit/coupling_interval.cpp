// The limits of the coupling interval: of the drag against the eigenvalues of the map that one
// interval is, of the crossing against single grains.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "coupling/interval_check.h"

namespace gasgrain {
namespace {

// |greatest eigenvalue|: |A^n|^(1/n) for n = 2^40. (Eigen's own takes 20 s to compile.)
double spectral_radius(Eigen::Matrix4d a) {
  double logarithm = 0.0;
  for (double share = 1.0; share > 1e-12; share *= 0.5) {
    const double norm = a.norm();
    logarithm += share * std::log(norm);
    a /= norm;
    a = a * a;
  }
  return std::exp(logarithm);
}

// Spectral radius of (u, v, c, w) -> (u', v', c', w'), interval_check.h.
double growth(double a, double solids, double q) {
  using Row = Eigen::RowVector4d;
  const double kappa = solids / (1.0 - solids);
  const double E = std::exp(-a);
  const Row u = Row::Unit(0);
  const Row v = Row::Unit(1);
  const Row c = Row::Unit(2);
  const Row w = Row::Unit(3);
  const Row u_new = -kappa * w;
  const Row G = kappa * (a * (u_new - v) + c) + q * (u_new - u);
  const Row v_end = u_new + G / a;
  const Row v_new = E * v + (1.0 - E) * v_end;
  const Row w_new = v_end + (v - v_end) * (1.0 - E) / a;
  Eigen::Matrix4d map;
  map << u_new, v_new, v_new - v - G - a * (u_new - v), w_new;
  return spectral_radius(map);
}

TEST(coupling_interval, drag_limit_is_where_the_map_of_one_interval_begins_to_grow) {
  int limited = 0;
  for (const double solids : {0.05, 0.1, 0.18, 0.2, 0.3, 0.45, 0.55, 0.6, 0.64})
    for (const double q : {0.0005, 0.01, 0.1, 0.4}) {
      const double limit = drag_limit(solids, q);
      if (std::isinf(limit)) {
        EXPECT_LT(solids, 0.19);
        for (const double a : {0.1, 1.0, 10.0, 1000.0}) EXPECT_LT(growth(a, solids, q), 1.0);
        continue;
      }
      ++limited;
      // The limit is sought to 0.01 %.
      EXPECT_LT(growth(0.999 * limit, solids, q), 1.0) << solids << ", " << q;
      EXPECT_GT(growth(1.001 * limit, solids, q), 1.0) << solids << ", " << q;
    }
  EXPECT_EQ(limited, 24);
}

TEST(coupling_interval, drag_limits_are_those_that_the_header_gives) {
  EXPECT_NEAR(drag_limit(0.60, 0.0005), 0.59, 0.005);
  EXPECT_NEAR(drag_limit(0.45, 0.0005), 1.07, 0.005);
  EXPECT_NEAR(drag_limit(0.30, 0.0005), 2.30, 0.01);
  EXPECT_TRUE(std::isinf(drag_limit(0.18, 0.0005)));
}

// One grain in a box of 10 x 10 x 10 mm with cells of 1 x 2 x 5 mm.
struct OneGrain {
  double x[3] = {5.5e-3, 5e-3, 5e-3};
  double v[3] = {0.0, 0.0, 0.0};
  double radius = 0.5e-3;
  double mass = 2500.0 * 4.0 / 3.0 * 3.14159265358979 * 0.125e-9;
  BoxGrid grid{Vec3::Zero(), Vec3::Constant(0.01), {10, 5, 2}};
  Array3<double> eps{grid.all(), 0.4};
  ExchangeRecords records;

  [[nodiscard]] IntervalNeed need(double interval, bool with_drag = true) {
    ParticleView view;
    view.count = 1;
    view.position = x;
    view.velocity = v;
    view.radius = &radius;
    view.mass = &mass;
    if (records.size() == 0) records.resize(1);
    return interval_need(view, records, {1.2, grid, with_drag ? &eps : nullptr, interval});
  }
};

TEST(coupling_interval, a_grain_that_crosses_more_than_a_cell_asks_for_half_a_cell) {
  OneGrain grain;
  grain.v[0] = -1.0;  // cells of 1 mm
  grain.v[1] = 1.5;   // of 2 mm
  grain.v[2] = 4.0;   // of 5 mm
  const IntervalNeed need = grain.need(1.5e-3);
  EXPECT_NEAR(need.crossing_rate, 1000.0, 1e-9);
  EXPECT_NEAR(need.cells_crossed(1.5e-3), 1.5, 1e-12);
  EXPECT_TRUE(need.too_long(1.01e-3));
  EXPECT_FALSE(need.too_long(0.99e-3));
  EXPECT_NEAR(need.advised(), 0.5e-3, 1e-12);
  EXPECT_NE(in_words(need, 1.5e-3).find("crosses 1.50 cells"), std::string::npos);
  EXPECT_EQ(in_words(need, 0.9e-3), "");
  EXPECT_EQ(every_to_write(need.advised(), 2e-6), "Write 'every 250'.");
}

TEST(coupling_interval, a_grain_in_a_dense_bed_asks_for_half_of_the_drag_limit) {
  OneGrain grain;
  grain.records.resize(1);
  grain.records.K(0) = grain.mass / 1e-3;  // m / K = 1 ms
  const double limit = 1e-3 * drag_limit(0.6, 1.2 / 2500.0);
  EXPECT_FALSE(grain.need(0.99 * limit).too_long(0.99 * limit));
  const IntervalNeed need = grain.need(2e-3);
  EXPECT_TRUE(need.too_long(2e-3));
  EXPECT_NEAR(need.advised() / (0.5 * limit), 1.0, 1e-3);
  EXPECT_NE(in_words(need, 2e-3).find("m / K"), std::string::npos);
  // In a dilute cell, and without drag, nothing limits it.
  EXPECT_FALSE(grain.need(2e-3, false).too_long(2e-3));
  grain.eps.fill(0.95);
  EXPECT_FALSE(grain.need(2e-3).too_long(2e-3));
}

TEST(coupling_interval, what_a_droplet_leaves_of_itself_asks_for_nothing) {
  OneGrain grain;
  const double x[6] = {5.5e-3, 5e-3, 5e-3, 5.5e-3, 5e-3, 5e-3};
  const double v[6] = {};
  const double radius[2] = {grain.radius, 1e-10};
  const double mass[2] = {grain.mass, 1e-26};
  double parcel_size[2] = {1000.0, 1000.0};
  ParticleView view;
  view.count = 2;
  view.position = x;
  view.velocity = v;
  view.radius = radius;
  view.mass = mass;
  view.parcel_size = parcel_size;
  ExchangeRecords records;
  records.resize(2);
  records.K(1) = mass[1] / 1e-9;
  EXPECT_FALSE(interval_need(view, records, {1.2, grain.grid, &grain.eps, 2e-3}).too_long(2e-3));
  // As many of them as weigh something do.
  parcel_size[1] = 1e24;
  EXPECT_TRUE(interval_need(view, records, {1.2, grain.grid, &grain.eps, 2e-3}).too_long(2e-3));
}

TEST(coupling_interval, needs_of_ranks_join_to_the_stricter_of_each) {
  IntervalNeed a;
  a.crossing_rate = 10.0;
  IntervalNeed b;
  b.longest_of_drag = 0.02;
  a.join(b);
  EXPECT_EQ(a.crossing_rate, 10.0);
  EXPECT_EQ(a.longest_of_drag, 0.02);
  EXPECT_NEAR(a.advised(), 0.01, 1e-15);
}

TEST(coupling_interval, what_to_write_has_two_digits_and_is_at_least_one) {
  EXPECT_EQ(every_to_write(0.01, 1e-5), "Write 'every 1000'.");
  EXPECT_EQ(every_to_write(1.37e-3, 1e-5), "Write 'every 130'.");
  EXPECT_EQ(every_to_write(9.9e-5, 1e-5), "Write 'every 9'.");
  EXPECT_EQ(every_to_write(1.5e-5, 1e-5), "Write 'every 1'.");
  EXPECT_EQ(every_to_write(2e-6, 1e-5), "Even 'every 1' is too long: lower 'timestep' to 2e-06.");
}

}  // namespace
}  // namespace gasgrain
