// Parcels that are divided over ranks by their places, cells of the border shared, against all of
// them on one rank.
#include <gtest/gtest.h>
#include <mpi.h>

#include "fix_cfd_coupling/dem_physics/parcels/return_to_isotropy.h"
#include "fix_cfd_coupling/dem_physics/parcels/velocity_damping.h"
#include "tests/exchange_model/parcel_cases.h"

namespace gasgrain {
namespace {

// Cells that several tiles hold get the sum over the ranks.
SumOverRanks sum_of_ranks(const TileFrame& frame) {
  return [frame](const std::vector<Array3<double>*>& fields) {
    for (Array3<double>* field : fields) {
      Array3<double> box(frame.grid.all(), 0.0);
      for_each_cell(field->box(), [&](int i, int j, int k) { box(i, j, k) += (*field)(i, j, k); });
      MPI_Allreduce(MPI_IN_PLACE, box.data(), static_cast<int>(box.size()), MPI_DOUBLE, MPI_SUM,
                    MPI_COMM_WORLD);
      for_each_cell(field->box(), [&](int i, int j, int k) { (*field)(i, j, k) = box(i, j, k); });
    }
  };
}

double total_of_ranks(double value) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

struct Step {
  ParcelSettings settings;
  ParticleStress stress{settings};
  ParcelMotion motion{settings.close_packing};
  MotionReport report;

  void take(Parcels& parcels, const TileFrame& frame, std::uint64_t n, const SumOverRanks& sum,
            const TotalOverRanks& total) {
    const double dt = 1e-3;
    std::vector<double> force(3 * parcels.count());
    for (std::size_t p = 0; p < parcels.count(); ++p) force[3 * p + 2] = -9.81 * parcels.mass[p];
    stress.add_forces(parcels.view(), frame, dt, force.data(), sum);
    for (std::size_t m = 0; m < force.size(); ++m)
      parcels.v[m] += dt * force[m] / parcels.mass[m / 3];
    const auto cells = parcel_cells(parcels.view(), frame);
    VelocityDamping{0.9, 0.6}.damp(parcels.view(), cells, frame, dt, sum);
    ReturnToIsotropy{0.9, 0.4, 0.6, 11}.redirect(parcels.view(), cells, frame, dt, n, sum);
    report = motion.move(parcels.view(), frame, dt, all_walls(), sum, total);
  }
};

TEST(parcels_on_ranks, do_as_on_one) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  ASSERT_EQ(ranks, 4);
  const BoxGrid grid = box_of({8, 8, 8}, 5e-3);
  Parcels all;
  fill(all, grid, {{0, 0, 0}, {8, 8, 5}}, 2, 0.57, 0.5e-3, 2500.0, Vec3::Zero());
  CounterRandom random(9, 0, 0);
  for (double& v : all.v) v = 0.5 * random.normal();

  Step one;
  Step shared;
  const TileFrame whole = whole_box(grid);
  int passes = 0;
  for (std::uint64_t n = 0; n < 6; ++n) {
    // What is in the rank's quarter of the box; its cells, with two more beyond its borders.
    Parcels mine;
    std::vector<std::size_t> index;
    const double half = 0.02;
    for (std::size_t p = 0; p < all.count(); ++p)
      if ((all.x[3 * p] >= half) == (rank % 2 == 1) &&
          (all.x[3 * p + 1] >= half) == (rank / 2 == 1)) {
        mine.add(all.view().x(p), all.view().v(p), all.radius[p], 2500.0, all.particles[p]);
        mine.number.back() = all.number[p];
        index.push_back(p);
      }
    IndexBox tile{{4 * (rank % 2), 4 * (rank / 2), 0}, {4 * (rank % 2) + 4, 4 * (rank / 2) + 4, 8}};
    tile = intersection(tile.grown(2), grid.all());
    const TileFrame frame{grid, tile};
    shared.take(mine, frame, n, sum_of_ranks(frame), total_of_ranks);
    one.take(all, whole, n, sum_of_one_rank(whole), total_of_one_rank);
    passes += one.report.passes;
    EXPECT_EQ(shared.report.passes, one.report.passes);
    for (std::size_t p = 0; p < index.size(); ++p)
      for (int d = 0; d < 3; ++d) {
        // A step from the same state, with sums in another order.
        ASSERT_NEAR(mine.x[3 * p + d], all.x[3 * index[p] + d], 1e-12);
        ASSERT_NEAR(mine.v[3 * p + d], all.v[3 * index[p] + d], 1e-12);
      }
  }
  EXPECT_GT(passes, 6);
}

}  // namespace
}  // namespace gasgrain
