// What holds for every void-fraction method of the LIST.
#include <gtest/gtest.h>

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

// A third of a cell across, and three cells.
const std::array<double, 2> radii{cloud_radius, 9.0 * cloud_radius};

// f(grid, radius) for all of them.
template <class F>
void for_each_bed(F&& f) {
  for (const auto& periodic : sides)
    for (const double radius : radii) f(uneven_box(periodic), radius);
}

// Particles inside, on every corner, edge and face of box and cells, and a little beyond walls.
Cloud awkward_cloud(const BoxGrid& grid, double radius) {
  Random random(1);
  Cloud cloud = random_cloud(grid, 300, random, radius);
  const Vec3 h = grid.spacing();
  for (int i = 0; i <= 2 * grid.cells[0]; ++i)
    for (int j = 0; j <= 2 * grid.cells[1]; ++j)
      for (int k = 0; k <= 2 * grid.cells[2]; ++k)
        cloud.add(grid.lo + 0.5 * h.cwiseProduct(Vec3(i, j, k)), Vec3::Zero(), radius);
  for (int d = 0; d < 3; ++d)
    if (!grid.periodic[d]) {
      Vec3 x = grid.lo;
      x[d] -= 0.7 * radius;
      cloud.add(x, Vec3::Zero(), radius);
      x = grid.hi;
      x[d] += 30.0 * radius;
      cloud.add(x, Vec3::Zero(), radius);
    }
  return cloud;
}

// What each cell of the tile gets of a particle.
Array3<double> shares_of(const VoidFractionMethod& method, const TileFrame& frame, const Vec3& x,
                         double radius) {
  Cloud cloud;
  cloud.add(x, Vec3::Zero(), radius);
  ParticleWeights weights;
  weights.find(cloud.view(), method, frame);
  Array3<double> shares(frame.tile);
  weights.deposit([](std::size_t) { return 1.0; }, shares);
  return shares;
}

TYPED_TEST(void_fraction, conserves_solid_volume_at_walls_corners_and_faces) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    const Cloud cloud = awkward_cloud(grid, radius);
    const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
    ParticleWeights weights;
    weights.find(cloud.view(), TypeParam{}, frame);
    Array3<double> solids(frame.tile);
    deposit_solid_volume(cloud.view(), weights, solids);
    double expected = 0.0;
    for (const double r : cloud.radius) expected += sphere_volume(r);
    const double deposited = std::accumulate(solids.begin(), solids.end(), 0.0);
    // Round-off of a sum of some thousand terms.
    EXPECT_NEAR(deposited / expected, 1.0, 1e-12);
  });
}

TYPED_TEST(void_fraction, gives_each_particle_positive_shares_that_sum_to_one_within_reach) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    const Cloud cloud = awkward_cloud(grid, radius);
    const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
    for (std::size_t p = 0; p < cloud.radius.size(); p += 5) {
      const Vec3 x = cloud.view().x(p);
      const Int3 reach =
          stencil_reach(with_diameter(TypeParam{}, 2.0 * radius), cloud.radius[p], grid);
      const Array3<double> shares =
          shares_of(with_diameter(TypeParam{}, 2.0 * radius), frame, x, cloud.radius[p]);
      double sum = 0.0;
      double outside = 0.0;
      for_each_cell(frame.tile, [&](int i, int j, int k) {
        const double w = shares(i, j, k);
        sum += w;
        EXPECT_GE(w, 0.0);
        const Int3 cell{i, j, k};
        for (int d = 0; d < 3; ++d) {
          const int own = frame.cell(frame.in_cells(x[d], d), d);
          if (std::abs(cell[d] - own) > reach[d]) outside += w;
        }
      });
      // Round-off of a sum over a thousand cells.
      EXPECT_NEAR(sum, 1.0, 1e-13) << "particle " << p;
      EXPECT_EQ(outside, 0.0) << "particle " << p;
    }
  });
}

TYPED_TEST(void_fraction, samples_with_the_adjoint_of_the_deposit) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    const Cloud cloud = awkward_cloud(grid, radius);
    const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
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
  });
}

TYPED_TEST(void_fraction, samples_a_uniform_field_exactly) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    const Cloud cloud = awkward_cloud(grid, radius);
    const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
    ParticleWeights weights;
    weights.find(cloud.view(), TypeParam{}, frame);
    const Array3<double> field(frame.tile, 0.42);
    weights.sample(field, [](std::size_t p, double value) {
      EXPECT_NEAR(value, 0.42, 1e-14) << "particle " << p;
    });
  });
}

// The share of a particle that changes cells as it moves by a small part of a cell: the stated
// jump where a face is crossed, and elsewhere no more than goes with the movement: that over a cell
// for the weights by distance, the sphere's greatest section times it for those by volume.
TYPED_TEST(void_fraction, moves_no_more_of_a_particle_at_once_than_it_states) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    const int steps = grid.periodic[0] ? 400 : 4000;
    const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
    for (int axis = 0; axis < 3; ++axis) {
      const double step = 2.0 * grid.spacing()[axis] / steps;
      Array3<double> before;
      double greatest = 0.0;
      for (int n = 0; n <= steps; ++n) {
        Vec3 x = grid.lo + 0.31 * grid.spacing();
        x[axis] += n * step;
        const Array3<double> now = wrapped(shares_of(TypeParam{}, frame, x, radius), grid);
        if (n > 0) {
          double changed = 0.0;
          for (std::size_t c = 0; c < now.size(); ++c) changed += std::max(0.0, now[c] - before[c]);
          greatest = std::max(greatest, changed);
        }
        before = now;
      }
      const double gradual = step * std::max(1.0 / grid.spacing()[axis], 0.75 / radius);
      EXPECT_LE(greatest, TypeParam::greatest_jump + 1.001 * gradual);
      EXPECT_GE(greatest, TypeParam::greatest_jump - 1e-12) << "the stated jump is never met";
    }
  });
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

// The deposit of a cloud and the samples of a field, once with one tile and once with two, each
// with the particles of one half and grown by the reach.
TYPED_TEST(void_fraction, does_not_depend_on_how_ranks_cut_the_box) {
  for_each_bed([](const BoxGrid& grid, double radius) {
    Random random(4);
    const Cloud cloud = random_cloud(grid, 300, random, radius);
    const VoidFractionMethod method = with_diameter(TypeParam{}, 2.0 * radius);
    const TileFrame whole = whole_frame(grid, method, radius);
    const double middle = grid.lo[2] + 0.47 * (grid.hi[2] - grid.lo[2]);

    ParticleWeights weights;
    weights.find(cloud.view(), method, whole);
    Array3<double> solids(whole.tile);
    deposit_solid_volume(cloud.view(), weights, solids);
    const Array3<double> expected = wrapped(solids, grid);
    Array3<double> lent(grid.all());
    random.fill(lent, -1.0, 1.0);
    const auto lent_to = [&](const IndexBox& tile) {
      Array3<double> field(tile);
      for_each_cell(tile, [&](int i, int j, int k) {
        Int3 cell{i, j, k};
        for (int d = 0; d < 3; ++d)
          cell[d] = ((cell[d] % grid.cells[d]) + grid.cells[d]) % grid.cells[d];
        field(i, j, k) = lent(cell[0], cell[1], cell[2]);
      });
      return field;
    };
    std::vector<double> sampled;
    weights.sample(lent_to(whole.tile), [&](std::size_t, double v) { sampled.push_back(v); });

    Array3<double> sum(grid.all());
    const Int3 reach = stencil_reach(method, radius, grid);
    for (const bool upper : {false, true}) {
      Cloud part;
      std::vector<std::size_t> index;
      for (std::size_t p = 0; p < cloud.radius.size(); ++p)
        if ((cloud.view().x(p)[2] > middle) == upper) {
          part.add(cloud.view().x(p), Vec3::Zero(), cloud.radius[p]);
          index.push_back(p);
        }
      TileFrame frame = whole;
      (upper ? frame.tile.lo : frame.tile.hi)[2] =
          grid.cell_of(middle, 2) + (upper ? -reach[2] : reach[2] + 1);
      if (!grid.periodic[2]) {
        frame.tile.lo[2] = std::max(0, frame.tile.lo[2]);
        frame.tile.hi[2] = std::min(grid.cells[2], frame.tile.hi[2]);
      }
      weights.find(part.view(), method, frame);
      Array3<double> share(frame.tile);
      deposit_solid_volume(part.view(), weights, share);
      const Array3<double> added = wrapped(share, grid);
      for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += added[n];
      weights.sample(lent_to(frame.tile),
                     [&](std::size_t p, double v) { EXPECT_NEAR(v, sampled[index[p]], 1e-14); });
    }
    for (std::size_t n = 0; n < sum.size(); ++n)
      EXPECT_NEAR(sum[n], expected[n], 1e-12 * sphere_volume(radius));
  });
}

// Cubes of cells, turned by a quarter about each axis.
TYPED_TEST(void_fraction, turns_with_the_bed) {
  for (const bool periodic : {false, true})
    for (const double radius : radii) {
      BoxGrid grid;
      grid.lo = Vec3::Constant(-0.01);
      grid.hi = Vec3::Constant(0.01);
      grid.cells = {7, 7, 7};
      grid.periodic = {periodic, periodic, periodic};
      const TileFrame frame = whole_frame(grid, TypeParam{}, radius);
      Random random(5);
      const Cloud cloud = random_cloud(grid, 200, random, radius);
      ParticleWeights weights;
      weights.find(cloud.view(), TypeParam{}, frame);
      Array3<double> field(frame.tile);
      deposit_solid_volume(cloud.view(), weights, field);
      const Array3<double> solids = wrapped(field, grid);
      for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3;
        const int b = (axis + 2) % 3;
        Cloud turned = cloud;
        for (std::size_t p = 0; p < cloud.radius.size(); ++p) {
          turned.position[3 * p + a] = -cloud.position[3 * p + b];
          turned.position[3 * p + b] = cloud.position[3 * p + a];
        }
        weights.find(turned.view(), TypeParam{}, frame);
        field.fill(0.0);
        deposit_solid_volume(turned.view(), weights, field);
        const Array3<double> turned_solids = wrapped(field, grid);
        for_each_cell(grid.all(), [&](int i, int j, int k) {
          const Int3 cell{i, j, k};
          Int3 to = cell;
          to[a] = grid.cells[a] - 1 - cell[b];
          to[b] = cell[a];
          EXPECT_NEAR(turned_solids(to[0], to[1], to[2]), solids(i, j, k),
                      1e-12 * sphere_volume(radius));
        });
      }
    }
}

TYPED_TEST(void_fraction, names_the_particle_that_is_outside_of_the_tile) {
  const BoxGrid grid = uneven_box(sides[2]);
  TileFrame frame = whole_frame(grid, TypeParam{});
  frame.tile.hi[2] = 2 + stencil_reach(TypeParam{}, cloud_radius, grid)[2];
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
