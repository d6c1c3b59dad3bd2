// What holds for every void-fraction method of the LIST.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "tests/exchange_cloud.h"
#include "tests/exchange_lists.h"

namespace gasgrain {
namespace {

template <class Method>
class void_fraction : public testing::Test {};

TYPED_TEST_SUITE(void_fraction, ListedTypes<VoidFractionMethod>::type, ListedName);

const std::array<std::array<bool, 3>, 3> sides{
    {{false, false, false}, {true, true, false}, {true, true, true}}};

// Particles inside, on every corner, edge and face of box and cells, and a little beyond walls.
Cloud awkward_cloud(const BoxGrid& grid) {
  Random random(1);
  Cloud cloud = random_cloud(grid, 300, random);
  const Vec3 h = grid.spacing();
  for (int i = 0; i <= 2 * grid.cells[0]; ++i)
    for (int j = 0; j <= 2 * grid.cells[1]; ++j)
      for (int k = 0; k <= 2 * grid.cells[2]; ++k)
        cloud.add(grid.lo + 0.5 * h.cwiseProduct(Vec3(i, j, k)), Vec3::Zero(), cloud_radius);
  for (int d = 0; d < 3; ++d)
    if (!grid.periodic[d]) {
      Vec3 x = grid.lo;
      x[d] -= 0.7 * cloud_radius;
      cloud.add(x, Vec3::Zero(), cloud_radius);
      x = grid.hi;
      x[d] += 30.0 * cloud_radius;
      cloud.add(x, Vec3::Zero(), cloud_radius);
    }
  return cloud;
}

TYPED_TEST(void_fraction, conserves_solid_volume_at_walls_corners_and_faces) {
  for (const auto& periodic : sides) {
    const BoxGrid grid = uneven_box(periodic);
    const Cloud cloud = awkward_cloud(grid);
    const TileFrame frame = whole_frame(grid, TypeParam{});
    ParticleWeights weights;
    weights.find(cloud.view(), TypeParam{}, frame);
    Array3<double> solids(frame.tile);
    deposit_solid_volume(cloud.view(), weights, solids);
    double expected = 0.0;
    for (const double r : cloud.radius) expected += sphere_volume(r);
    const double deposited = std::accumulate(solids.begin(), solids.end(), 0.0);
    // Round-off of a sum of some thousand terms.
    EXPECT_NEAR(deposited / expected, 1.0, 1e-12);
  }
}

TYPED_TEST(void_fraction, gives_each_particle_positive_weights_that_sum_to_one_within_reach) {
  for (const auto& periodic : sides) {
    const BoxGrid grid = uneven_box(periodic);
    const Cloud cloud = awkward_cloud(grid);
    const TileFrame frame = whole_frame(grid, TypeParam{});
    for (std::size_t p = 0; p < cloud.radius.size(); ++p) {
      const Vec3 x = cloud.view().x(p);
      const int reach = stencil_reach(TypeParam{}, cloud.radius[p], grid);
      double sum = 0.0;
      TypeParam::for_each_weight(frame, x, cloud.radius[p], [&](int i, int j, int k, double w) {
        sum += w;
        EXPECT_GE(w, 0.0);
        const Int3 cell{i, j, k};
        for (int d = 0; d < 3; ++d) {
          const int own = frame.cell(frame.in_cells(x[d], d), d);
          EXPECT_LE(std::abs(cell[d] - own), reach) << "axis " << d << " of particle " << p;
        }
      });
      EXPECT_NEAR(sum, 1.0, 1e-14) << "particle " << p;
    }
  }
}

TYPED_TEST(void_fraction, samples_with_the_adjoint_of_the_deposit) {
  for (const auto& periodic : sides) {
    const BoxGrid grid = uneven_box(periodic);
    const Cloud cloud = awkward_cloud(grid);
    const TileFrame frame = whole_frame(grid, TypeParam{});
    ParticleWeights weights;
    weights.find(cloud.view(), TypeParam{}, frame);
    Random random(2);
    VectorField field = make_vector_field(frame.tile);
    for (auto& component : field) random.fill(component, -1.0, 1.0);
    std::vector<Vec3> q(cloud.radius.size());
    for (auto& value : q) value = random.vector(1.0);

    VectorField deposited = make_vector_field(frame.tile);
    weights.deposit([&](std::size_t p) { return q[p]; }, deposited);
    double on_cells = 0.0;
    for (int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < field[d].size(); ++n) on_cells += field[d][n] * deposited[d][n];
    double on_particles = 0.0;
    double scale = 0.0;
    weights.sample(field, [&](std::size_t p, const Vec3& value) {
      on_particles += q[p].dot(value);
      scale += std::abs(q[p].dot(value));
    });
    EXPECT_NEAR(on_cells / scale, on_particles / scale, 1e-13);
  }
}

TYPED_TEST(void_fraction, samples_a_uniform_field_exactly) {
  const BoxGrid grid = uneven_box(sides[1]);
  const Cloud cloud = awkward_cloud(grid);
  const TileFrame frame = whole_frame(grid, TypeParam{});
  ParticleWeights weights;
  weights.find(cloud.view(), TypeParam{}, frame);
  const Array3<double> field(frame.tile, 0.42);
  weights.sample(field, [](std::size_t p, double value) {
    EXPECT_NEAR(value, 0.42, 1e-15) << "particle " << p;
  });
}

// The share of a particle that changes cells as it moves by a ten-thousandth of a cell: the stated
// jump where a face is crossed, and elsewhere no more than goes with the movement: that over a cell
// for the weights by distance, the sphere's greatest section times it for those by volume.
TYPED_TEST(void_fraction, moves_no_more_of_a_particle_at_once_than_it_states) {
  const BoxGrid grid = uneven_box(sides[0]);
  const TileFrame frame = whole_frame(grid, TypeParam{});
  const int steps = 20000;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = 2.0 * grid.spacing()[axis] / steps;
    std::map<Int3, double> before;
    double greatest = 0.0;
    for (int n = 0; n <= steps; ++n) {
      Vec3 x = grid.lo + 0.31 * grid.spacing();
      x[axis] += n * step;
      std::map<Int3, double> now;
      TypeParam::for_each_weight(frame, x, cloud_radius, [&](int i, int j, int k, double w) {
        now[{i, j, k}] += w;
      });
      if (n > 0) {
        double changed = 0.0;
        for (const auto& [cell, w] : now) changed += std::max(0.0, w - before[cell]);
        greatest = std::max(greatest, changed);
      }
      before = now;
    }
    const double gradual = step * std::max(1.0 / grid.spacing()[axis], 0.75 / cloud_radius);
    EXPECT_LE(greatest, TypeParam::greatest_jump + 1.001 * gradual);
    EXPECT_GE(greatest, TypeParam::greatest_jump - 1e-12) << "the stated jump is never met";
  }
}

TYPED_TEST(void_fraction, does_not_depend_on_where_the_box_is) {
  BoxGrid grid = uneven_box(sides[1]);
  const TileFrame frame = whole_frame(grid, TypeParam{});
  const Vec3 shift(0.3, -0.7, 1.1);
  BoxGrid moved = grid;
  moved.lo += shift;
  moved.hi += shift;
  const TileFrame moved_frame{moved, frame.tile};
  Random random(3);
  Cloud cloud = random_cloud(grid, 200, random);
  Array3<double> solids(frame.tile);
  Array3<double> moved_solids(frame.tile);
  ParticleWeights weights;
  weights.find(cloud.view(), TypeParam{}, frame);
  deposit_solid_volume(cloud.view(), weights, solids);
  for (std::size_t p = 0; p < cloud.radius.size(); ++p)
    for (int d = 0; d < 3; ++d) cloud.position[3 * p + d] += shift[d];
  weights.find(cloud.view(), TypeParam{}, moved_frame);
  deposit_solid_volume(cloud.view(), weights, moved_solids);
  for (std::size_t n = 0; n < solids.size(); ++n)
    EXPECT_NEAR(solids[n], moved_solids[n], 1e-10 * sphere_volume(cloud_radius));
}

TYPED_TEST(void_fraction, names_the_particle_that_is_outside_of_the_tile) {
  const BoxGrid grid = uneven_box(sides[2]);
  TileFrame frame = whole_frame(grid, TypeParam{});
  frame.tile.hi[2] = 4;
  for (const double height : {0.03, std::nan("")}) {
    Cloud cloud;
    cloud.add(grid.lo + grid.spacing(), Vec3::Zero(), cloud_radius);
    cloud.add(Vec3(0.0, 0.005, height), Vec3::Zero(), cloud_radius);
    ParticleWeights weights;
    try {
      weights.find(cloud.view(), TypeParam{}, frame);
      FAIL() << "a particle outside of the tile was accepted";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("particle 1 "), std::string::npos) << e.what();
    }
  }
}

TYPED_TEST(void_fraction, counts_particles_beyond_walls) {
  const BoxGrid grid = uneven_box({true, false, false});
  Cloud cloud;
  cloud.add(Vec3(0.0, 0.005, -1e-4), Vec3::Zero(), cloud_radius);
  cloud.add(Vec3(0.0, 0.005, 1e-4), Vec3::Zero(), cloud_radius);
  ParticleWeights weights;
  weights.find(cloud.view(), TypeParam{}, whole_frame(grid, TypeParam{}));
  EXPECT_EQ(weights.beyond_walls(), 1U);
}

}  // namespace
}  // namespace gasgrain
