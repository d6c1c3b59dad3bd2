// The motion of parcels up to close packing.
#include <gtest/gtest.h>

#include <numeric>

#include "coupling/base/error.h"
#include "tests/exchange_model/parcel_cases.h"

namespace gasgrain {
namespace {

constexpr double packed = 0.6;
constexpr double radius = 0.5e-3;
// 1 %, and what a cell that is there already may gain by round-off.
constexpr double bound = 1.01 * packed * (1.0 + 1e-9);

ParcelSettings settings(const Walls& walls, bool stress) {
  ParcelSettings s;
  s.close_packing = packed;
  s.walls = walls;
  s.stress = stress;
  return s;
}

// Parcels are 8 a cell with random places: at 0.3 their cells hold up to 0.5.
TEST(parcels, fall_and_settle_to_a_bed_at_rest_of_the_packed_height) {
  for (const double h : {5e-3, 1e-2}) {
    const int nz = static_cast<int>(0.24 / h);
    Bed bed(box_of({3, 3, nz}, h), settings(all_walls(), true));
    fill(bed.parcels, bed.grid, {{0, 0, 0}, {3, 3, nz}}, 2, 0.3, radius, 2500.0, Vec3::Zero());
    const double dt = 1e-3;
    // From 0.12 m above its place the centre falls for 0.16 s.
    for (int n = 0; n < 300; ++n) {
      bed.step(dt);
      ASSERT_LE(bed.motion_report.greatest_fraction, bound) << "step " << n;
      ASSERT_FALSE(bed.motion_report.all_held);
    }
    double centre = 0.0;
    for (std::size_t p = 0; p < bed.parcels.count(); ++p)
      centre += bed.parcels.x[3 * p + 2] / static_cast<double>(bed.parcels.count());
    // The motion fills cells to 0.995, a floor's and a top's are less even.
    EXPECT_NEAR(2.0 * centre / (0.24 * 0.3 / packed), 1.0, 0.06) << "h " << h;
    // One step of gravity is 10 mm/s.
    const double rms = std::sqrt(2.0 * bed.parcels.kinetic_energy() / bed.parcels.total_mass());
    EXPECT_LT(rms, 0.2 * 9.81 * dt) << "h " << h;
  }
}

// A bed of 0.3 m neither shakes nor breathes nor sinks.
TEST(parcels, of_a_deep_bed_stay_at_rest) {
  Bed bed(box_of({3, 3, 36}, 1e-2), settings(all_walls(), true));
  fill(bed.parcels, bed.grid, {{0, 0, 0}, {3, 3, 36}}, 2, 0.5, radius, 1000.0, Vec3::Zero());
  const auto height = [&] {
    double centre = 0.0;
    for (std::size_t p = 0; p < bed.parcels.count(); ++p) centre += bed.parcels.x[3 * p + 2];
    return 2.0 * centre / static_cast<double>(bed.parcels.count());
  };
  for (int n = 0; n < 250; ++n) bed.step(1e-3);
  const double first = height();
  for (int n = 0; n < 150; ++n) {
    bed.step(1e-3);
    const double rms = std::sqrt(2.0 * bed.parcels.kinetic_energy() / bed.parcels.total_mass());
    ASSERT_LT(rms, 0.3 * 9.81e-3) << "step " << n;
  }
  EXPECT_NEAR(height() / first, 1.0, 2e-3);
  EXPECT_NEAR(height() / 0.3, 1.0, 0.04);
}

TEST(parcels, that_all_run_to_one_place_never_fill_a_cell_beyond_the_bound) {
  for (const double speed : {0.5, 5.0}) {
    Bed bed(box_of({8, 8, 8}, 5e-3), settings(all_walls(), false));
    bed.gravity.setZero();
    fill(bed.parcels, bed.grid, bed.grid.all(), 2, 0.45, radius, 2500.0, Vec3::Zero(), 0.5);
    const Vec3 middle = 0.5 * bed.grid.hi;
    for (int n = 0; n < 40; ++n) {
      for (std::size_t p = 0; p < bed.parcels.count(); ++p) {
        const Vec3 to = middle - bed.parcels.view().x(p);
        for (int d = 0; d < 3; ++d) bed.parcels.v[3 * p + d] = speed * to[d] / (to.norm() + 1e-9);
      }
      bed.step(1e-3);
      ASSERT_LE(bed.motion_report.greatest_fraction, bound) << "step " << n;
      ASSERT_FALSE(bed.motion_report.all_held);
    }
    EXPECT_GT(bed.motion_report.limited, 0U);
  }
}

TEST(parcels, of_cells_that_are_too_full_already_make_none_fuller) {
  Bed bed(box_of({6, 6, 6}, 5e-3), settings(all_walls(), false));
  fill(bed.parcels, bed.grid, bed.grid.all(), 2, 0.62, radius, 2500.0, Vec3::Zero());
  CounterRandom random(3, 0, 0);
  for (double& v : bed.parcels.v) v = 2.0 * random.normal();
  const TileFrame frame = whole_box(bed.grid);
  const auto fractions = [&] {
    ParticleStress deposit(settings({}, false));
    std::vector<double> force(3 * bed.parcels.count());
    deposit.add_forces(bed.parcels.view(), frame, 1e-3, force.data(), sum_of_one_rank(frame));
    return deposit.solid_fraction();
  };
  const Array3<double> first = fractions();
  bed.step(1e-3);
  const Array3<double> then = fractions();
  int too_full = 0;
  for (std::size_t n = 0; n < then.size(); ++n) {
    too_full += first[n] > 1.01 * packed;
    EXPECT_LE(then[n], std::max(bound, first[n] * (1.0 + 1e-9)));
  }
  EXPECT_GT(too_full, 50);
}

// A column through both ends of a periodic box, with even cells and with cells up to the bound.
TEST(parcels, that_are_packed_move_on_as_a_plug) {
  for (const double offset : {0.0, 0.2}) {
    BoxGrid grid = box_of({4, 4, 8}, 5e-3);
    grid.periodic = {false, false, true};
    Walls walls = all_walls();
    walls.side[2] = {false, false};
    Bed bed(grid, settings(walls, true));
    bed.gravity.setZero();
    const double theta = offset == 0.0 ? packed : 0.965 * packed;
    fill(bed.parcels, grid, grid.all(), 2, theta, radius, 2500.0, Vec3(0.0, 0.0, 0.5), offset);
    const double before = bed.parcels.momentum().z();
    for (int n = 0; n < 40; ++n) {  // four cells
      bed.step(1e-3);
      ASSERT_LE(bed.motion_report.greatest_fraction, bound);
    }
    EXPECT_NEAR(bed.parcels.momentum().z() / before, 1.0, 2e-3);
  }
}

// A bed as it comes to rest has its own pattern of full cells, which does not fit to the grid once
// it has moved by part of a cell.
TEST(parcels, of_a_settled_bed_that_is_thrown_up_keep_its_momentum) {
  Bed bed(box_of({3, 3, 40}, 5e-3), settings(all_walls(), true));
  fill(bed.parcels, bed.grid, {{0, 0, 0}, {3, 3, 24}}, 2, 0.3, radius, 2500.0, Vec3::Zero());
  for (int n = 0; n < 200; ++n) bed.step(1e-3);
  for (std::size_t n = 0; n < bed.parcels.v.size(); ++n) bed.parcels.v[n] = n % 3 == 2 ? 1.0 : 0.0;
  bed.gravity.setZero();
  const double before = bed.parcels.momentum().z();
  for (int n = 0; n < 60; ++n) {  // 12 cells
    bed.step(1e-3);
    ASSERT_LE(bed.motion_report.greatest_fraction, bound);
  }
  // Measured: 5 % lost, in the first cells of its way.
  EXPECT_NEAR(bed.parcels.momentum().z() / before, 1.0, 0.07);
}

TEST(parcels, account_for_the_momentum_that_packing_and_walls_take) {
  Bed bed(box_of({4, 4, 12}, 5e-3), settings(all_walls(), false));
  bed.gravity.setZero();
  fill(bed.parcels, bed.grid, {{0, 0, 0}, {4, 4, 6}}, 2, 0.59, radius, 2500.0, Vec3::Zero(), 0.2);
  fill(bed.parcels, bed.grid, {{1, 1, 8}, {3, 3, 11}}, 2, 0.2, radius, 2500.0,
       Vec3(0.3, 0.0, -3.0));
  double energy = bed.parcels.kinetic_energy();
  const double scale = bed.parcels.momentum().norm();
  bool packing = false;
  for (int n = 0; n < 30; ++n) {
    const Vec3 before = bed.parcels.momentum();
    bed.step(1e-3);
    const Vec3 taken = bed.motion_report.lost_momentum + bed.motion_report.wall_impulse;
    EXPECT_LT((before - bed.parcels.momentum() - taken).norm(), 1e-12 * scale);
    EXPECT_LE(bed.parcels.kinetic_energy(), energy * (1.0 + 1e-12));
    energy = bed.parcels.kinetic_energy();
    packing = packing || bed.motion_report.limited > 0;
  }
  EXPECT_TRUE(packing);
}

TEST(parcels, rebound_from_walls_with_their_retention_and_leave_through_open_sides) {
  const BoxGrid grid = box_of({4, 4, 4}, 1e-2);
  Walls walls;
  walls.side[2][0] = true;
  const Vec3 v(1.0, 0.0, -2.0);
  // It meets the plane at its radius after 1 ms, and goes on for 1 ms.
  const FreeFlight flight = fly(Vec3(0.02, 0.02, radius + 2e-3), v, radius, 2e-3, grid, walls);
  EXPECT_EQ(flight.rebounds, 1);
  EXPECT_NEAR(flight.velocity.z(), 0.3 * 2.0, 1e-14);
  EXPECT_NEAR(flight.velocity.x(), 0.99, 1e-14);
  EXPECT_NEAR(flight.position.z(), radius + 0.6e-3, 1e-15);
  EXPECT_NEAR(flight.position.x(), 0.02 + 1e-3 + 0.99e-3, 1e-15);

  Bed bed(grid, settings(walls, true));
  bed.gravity.setZero();
  bed.parcels.add(Vec3(0.02, 0.02, 0.039), Vec3(0.0, 0.0, 2.0), radius, 2500.0, 10.0);
  bed.step(1e-3);
  EXPECT_EQ(bed.motion_report.outside, 1U);
  EXPECT_NEAR(bed.parcels.x[2], 0.041, 1e-15);
}

TEST(parcels, of_liquid_go_between_packed_grains) {
  Bed bed(box_of({4, 4, 4}, 5e-3), settings(all_walls(), false));
  bed.gravity.setZero();
  fill(bed.parcels, bed.grid, bed.grid.all(), 2, packed, radius, 2500.0, Vec3::Zero(), 0.0);
  bed.parcels.add(Vec3(0.01, 0.01, 0.018), Vec3(0.0, 0.0, -3.0), 50e-6, 1000.0, 1e3);
  bed.parcels.solid_volume.back() = 4.0 / 3.0 * M_PI * 1e-30;
  bed.step(1e-3);
  EXPECT_NEAR(bed.parcels.x.back(), 0.015, 1e-12);
}

TEST(parcels, do_not_leave_the_cells_that_their_rank_holds) {
  const BoxGrid grid = box_of({8, 4, 4}, 5e-3);
  Parcels parcels;
  parcels.add(Vec3(0.01, 0.01, 0.01), Vec3(30.0, 0.0, 0.0), radius, 2500.0, 10.0);
  const TileFrame frame{grid, {{0, 0, 0}, {5, 4, 4}}};
  ParcelMotion motion(packed);
  const MotionReport report =
      motion.move(parcels.view(), frame, 1e-3, {}, sum_of_one_rank(frame), total_of_one_rank);
  EXPECT_EQ(report.cut_at_tile, 1U);
  EXPECT_NEAR(parcels.x[0], 4.5 * 5e-3, 1e-9);
  parcels.x[0] = 0.039;
  EXPECT_THROW(
      motion.move(parcels.view(), frame, 1e-3, {}, sum_of_one_rank(frame), total_of_one_rank),
      Error);
}

}  // namespace
}  // namespace gasgrain
