// The loops over particles: forces as stated, and effects that are off leave no trace.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "coupling/exchange/bed_measures.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

struct Bed {
  BoxGrid grid = uneven_box({false, false, false});
  TileFrame frame{grid, grid.all()};
  Random random{11};
  Cloud cloud = random_cloud(grid, 100, random);
  VectorField velocity = make_vector_field(frame.tile);
  VectorField pressure_gradient = make_vector_field(frame.tile);
  Array3<double> void_fraction{frame.tile, 0.5};

  Bed() {
    for (auto& component : velocity) random.fill(component, -1.0, 1.0);
  }

  // The forces on the particles after one coupling, on top of 1 N.
  std::vector<double> forces(const Effects& effects, std::vector<ExchangeRecord>& records) {
    ParticleWeights weights;
    weights.find(cloud.view(), effects.method, frame);
    records.assign(cloud.radius.size(), {});
    if (effects.drag)
      refresh_drag(cloud.view(), weights, *effects.drag, {1.2, 1.8e-5}, void_fraction, velocity,
                   records.data());
    LentFields lent;
    if (effects.lent().has(GasField::velocity)) lent.velocity = &velocity;
    if (effects.lent().has(GasField::pressure_gradient))
      lent.pressure_gradient = &pressure_gradient;
    set_records(cloud.view(), weights, effects, lent, 1e-4, records.data());
    std::vector<double> force(cloud.velocity.size(), 1.0);
    apply_forces(cloud.view(), effects, records.data(), force.data(), 1e-5);
    return force;
  }
};

TEST(particle_exchange, without_effects_changes_no_bit) {
  Bed bed;
  std::vector<ExchangeRecord> records;
  const auto force = bed.forces(Effects{}, records);
  EXPECT_EQ(force, std::vector<double>(force.size(), 1.0));
  const ExchangeRecord untouched;
  for (const auto& record : records) EXPECT_EQ(std::memcmp(&record, &untouched, sizeof(record)), 0);
}

TEST(particle_exchange, with_a_force_that_is_zero_equals_one_that_is_absent_bit_for_bit) {
  Bed bed;
  std::vector<ExchangeRecord> records;
  const auto absent = bed.forces(parse_effects({"drag", "koch_hill"}, "test"), records);
  const auto zero =
      bed.forces(parse_effects({"drag", "koch_hill", "pressure_gradient"}, "test"), records);
  EXPECT_EQ(absent, zero);
}

TEST(particle_exchange, pushes_particles_down_the_pressure_gradient) {
  Bed bed;
  bed.pressure_gradient[2].fill(-1e4);
  std::vector<ExchangeRecord> records;
  const auto force = bed.forces(parse_effects({"pressure_gradient"}, "test"), records);
  for (std::size_t p = 0; p < bed.cloud.radius.size(); ++p) {
    EXPECT_EQ(force[3 * p], 1.0);
    EXPECT_NEAR(force[3 * p + 2] - 1.0, 1e4 * sphere_volume(bed.cloud.radius[p]), 1e-15);
    EXPECT_EQ(as_vec3(records[p].taken), Vec3::Zero());
  }
}

TEST(particle_exchange, drags_particles_towards_the_gas_with_their_current_velocity) {
  Bed bed;
  for (int d = 0; d < 3; ++d) bed.velocity[d].fill(d + 1.0);
  const Effects effects = parse_effects({"drag", "koch_hill"}, "test");
  std::vector<ExchangeRecord> records;
  bed.forces(effects, records);
  for (double& v : bed.cloud.velocity) v = 0.25;
  std::vector<double> force(bed.cloud.velocity.size(), 0.0);
  const auto before = records;
  const AppliedDrag applied =
      apply_forces(bed.cloud.view(), effects, records.data(), force.data(), 2e-5);
  Vec3 sum = Vec3::Zero();
  for (std::size_t p = 0; p < records.size(); ++p) {
    EXPECT_GT(records[p].K, 0.0);
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(force[3 * p + d] / (records[p].K * (d + 0.75)), 1.0, 1e-13);
      EXPECT_NEAR(records[p].taken[d] - before[p].taken[d], 2e-5 * force[3 * p + d], 1e-18);
      sum[d] += 2e-5 * force[3 * p + d];
    }
  }
  EXPECT_NEAR((applied.impulse - sum).norm(), 0.0, 1e-13 * sum.norm());
  EXPECT_NEAR(applied.magnitude / sum.lpNorm<1>(), 1.0, 1e-13);
}

TEST(particle_exchange, names_the_field_that_the_gas_did_not_return) {
  Bed bed;
  ParticleWeights weights;
  weights.find(bed.cloud.view(), VoidFractionCentre{}, bed.frame);
  std::vector<ExchangeRecord> records(bed.cloud.radius.size());
  const Effects effects = parse_effects({"pressure_gradient"}, "test");
  try {
    set_records(bed.cloud.view(), weights, effects, {}, 1e-4, records.data());
    FAIL() << "an absent field was accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("pressure_gradient"), std::string::npos);
  }
}

TEST(particle_exchange, counts_particles_in_cells_too_dense_for_drag) {
  Bed bed;
  bed.void_fraction.fill(-0.1);
  ParticleWeights weights;
  weights.find(bed.cloud.view(), VoidFractionCentre{}, bed.frame);
  std::vector<ExchangeRecord> records(bed.cloud.radius.size());
  const DragRefresh refresh = refresh_drag(bed.cloud.view(), weights, DragKochHill{}, {1.2, 1.8e-5},
                                           bed.void_fraction, bed.velocity, records.data());
  EXPECT_EQ(refresh.too_dense, records.size());
  EXPECT_DOUBLE_EQ(refresh.least_void_fraction, -0.1);
}

TEST(particle_weights, refuse_a_field_of_another_box) {
  Bed bed;
  ParticleWeights weights;
  weights.find(bed.cloud.view(), VoidFractionCentre{}, bed.frame);
  Array3<double> other(bed.frame.tile.grown(1));
  EXPECT_THROW(deposit_solid_volume(bed.cloud.view(), weights, other), Error);
}

TEST(bed_measures, find_the_height_of_a_column_within_a_bin) {
  Cloud cloud;
  const double r = 1e-3;
  for (int n = 0; n < 1000; ++n) cloud.add(Vec3(0.0, 0.0, r + n * 1e-4), Vec3::Zero(), r);
  BedMeasures measures(2, 0.0, 1.0);
  measures.add(cloud.view());
  // Tops from 2 mm in steps of 0.1 mm; a bin has 0.5 mm.
  EXPECT_NEAR(measures.height(0.995), 2e-3 + 995 * 1e-4, 5e-4);
  EXPECT_NEAR(measures.height(0.5), 2e-3 + 500 * 1e-4, 5e-4);
  EXPECT_NEAR(measures.solid_volume() / (1000 * sphere_volume(r)), 1.0, 1e-12);
  EXPECT_EQ(measures.count(), 1000.0);
}

TEST(bed_measures, of_ranks_add_up) {
  Random random(5);
  const BoxGrid grid = uneven_box({false, false, false});
  const Cloud a = random_cloud(grid, 300, random);
  const Cloud b = random_cloud(grid, 200, random);
  BedMeasures one(2, grid.lo[2], grid.hi[2]);
  BedMeasures other = one;
  BedMeasures together = one;
  one.add(a.view());
  other.add(b.view());
  together.add(a.view());
  together.add(b.view());
  for (std::size_t n = 0; n < one.values().size(); ++n) one.values()[n] += other.values()[n];
  EXPECT_NEAR(one.height(), together.height(), 1e-12);
  EXPECT_NEAR(one.kinetic_energy() / together.kinetic_energy(), 1.0, 1e-13);
}

TEST(bed_measures, hold_the_energy_of_translation_and_rotation) {
  Cloud cloud;
  cloud.add(Vec3(0.0, 0.0, 0.5), Vec3(3.0, 0.0, 4.0), 0.1, 2.0);
  const Vec3 spin(0.0, 10.0, 0.0);
  ParticleView view = cloud.view();
  BedMeasures still(2, 0.0, 1.0);
  still.add(view);
  EXPECT_DOUBLE_EQ(still.kinetic_energy(), 25.0);
  view.angular_velocity = spin.data();
  BedMeasures spinning(2, 0.0, 1.0);
  spinning.add(view);
  EXPECT_DOUBLE_EQ(spinning.rotation_energy(), 0.5 * (0.4 * 2.0 * 0.01) * 100.0);
}

TEST(bed_measures, of_no_particles_lie_at_the_bottom) {
  EXPECT_EQ(BedMeasures(2, 0.25, 1.0).height(), 0.25);
  EXPECT_THROW(BedMeasures(2, 1.0, 0.25), Error);
}

}  // namespace
}  // namespace gasgrain
