// The loops over particles: forces as stated, and effects that are off leave no trace.
#include <gtest/gtest.h>

#include <numeric>

#include "coupling/exchange/applied_forces.h"
#include "coupling/exchange/bed_measures.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

constexpr GasProperties air{1.2, 1.8e-5};

struct Bed {
  BoxGrid grid = uneven_box({false, false, false});
  TileFrame frame{grid, grid.all()};
  Random random{11};
  Cloud cloud = random_cloud(grid, 100, random);
  Vec3 pressure_gradient = Vec3::Zero();
  std::array<Array3<double>, 3> velocity{Array3<double>(frame.tile), Array3<double>(frame.tile),
                                         Array3<double>(frame.tile)};
  double void_fraction = 0.5;
  double sauter_diameter = 0.0;
  double dt = 1e-5;
  AppliedForces applied;

  Bed() {
    for (auto& component : velocity) random.fill(component, -1.0, 1.0);
  }

  ExchangeRecords couple(const Effects& effects) {
    ParticleWeights weights;
    weights.find(cloud.view(), effects.method, frame);
    FieldStore fields(effects.lent().united(effects.taken()), frame.tile);
    if (fields.has(GasField::velocity)) fields.vector(GasField::velocity) = velocity;
    if (fields.has(GasField::void_fraction))
      fields.scalar(GasField::void_fraction).fill(void_fraction);
    if (fields.has(GasField::sauter_diameter))
      fields.scalar(GasField::sauter_diameter).fill(sauter_diameter);
    if (fields.has(GasField::pressure_gradient))
      for (int d = 0; d < 3; ++d)
        fields.vector(GasField::pressure_gradient)[d].fill(pressure_gradient[d]);
    ExchangeRecords records(effects.layout(false));
    records.resize(cloud.radius.size());
    if (effects.drag) {
      too_dense = refresh_drag(cloud.view(), weights, effects, air, fields, records);
      deposit_drag(cloud.view(), weights, effects, grid.cell_volume(), 1e-4, fields, records);
      book_expected(cloud.view(), weights, effects, fields, 1e-4, records);
    }
    set_gas_at_particles(cloud.view(), weights, effects, air, fields, 1e-4, records);
    return records;
  }

  // The forces on the particles, on top of `before` [N].
  std::vector<double> apply(const Effects& effects, ExchangeRecords& records, double before) {
    std::vector<double> force(cloud.velocity.size(), before);
    std::vector<double> torque(cloud.velocity.size(), 0.0);
    ForceLoop loop(effects, air);
    loop.apply(cloud.view(), records, {force.data(), torque.data()}, dt, 1.0);
    applied = loop.applied();
    return force;
  }
  std::vector<double> forces(const Effects& effects) {
    ExchangeRecords records = couple(effects);
    return apply(effects, records, 1.0);
  }

  DragRefresh too_dense;
};

TEST(particle_exchange, without_effects_changes_no_bit) {
  Bed bed;
  ExchangeRecords records = bed.couple(Effects{});
  EXPECT_EQ(records.layout().size, ExchangeRecords().layout().size);
  for (std::size_t p = 0; p < records.size(); ++p)
    for (int n = 0; n < records.layout().size; ++n) EXPECT_EQ(records.row(p)[n], 0.0);
  const auto force = bed.apply(Effects{}, records, 1.0);
  EXPECT_EQ(force, std::vector<double>(force.size(), 1.0));
}

// Fields that are 0, no spin, no charge. (Virtual mass and history are never 0: they are inertia.)
TEST(particle_exchange, with_a_force_that_is_zero_equals_one_that_is_absent_bit_for_bit) {
  Bed bed;
  const auto absent = bed.forces(parse_effects({"drag", "koch_hill"}, "test"));
  for (const char* force : {"pressure_gradient", "viscous_stress", "saffman_mei", "magnus",
                            "rotation_torque", "lorentz"})
    EXPECT_EQ(absent, bed.forces(parse_effects({"drag", "koch_hill", force}, "test"))) << force;
}

TEST(particle_exchange, pushes_particles_down_the_pressure_gradient) {
  Bed bed;
  bed.pressure_gradient[2] = -1e4;
  const Effects effects = parse_effects({"pressure_gradient"}, "test");
  ExchangeRecords records = bed.couple(effects);
  const auto force = bed.apply(effects, records, 1.0);
  for (std::size_t p = 0; p < bed.cloud.radius.size(); ++p) {
    EXPECT_EQ(force[3 * p], 1.0);
    EXPECT_NEAR(force[3 * p + 2] - 1.0, 1e4 * sphere_volume(bed.cloud.radius[p]), 1e-15);
    EXPECT_EQ(records.taken(p), Vec3::Zero());
  }
  EXPECT_NEAR(bed.applied.host[2] / (1e-5 * 100), 1.0, 1e-13);
  EXPECT_GT(bed.applied.free[2], 0.0);
  EXPECT_EQ(bed.applied.reacting, Vec3::Zero());
}

TEST(particle_exchange, drags_particles_towards_the_gas_with_their_current_velocity) {
  Bed bed;
  for (int d = 0; d < 3; ++d) bed.velocity[d].fill(d + 1.0);
  const Effects effects = parse_effects({"drag", "koch_hill"}, "test");
  ExchangeRecords records = bed.couple(effects);
  for (double& v : bed.cloud.velocity) v = 0.25;
  const auto force = bed.apply(effects, records, 0.0);
  Vec3 sum = Vec3::Zero();
  for (std::size_t p = 0; p < records.size(); ++p) {
    EXPECT_GT(records.K(p), 0.0);
    for (int d = 0; d < 3; ++d) {
      // The mean over the step of the drag on a grain that nothing else acts on.
      const double a = records.K(p) * bed.dt / bed.cloud.mass[p];
      const double mean = records.K(p) * (d + 0.75) * -std::expm1(-a) / a;
      EXPECT_NEAR(force[3 * p + d] / mean, 1.0, 1e-13);
      EXPECT_NEAR(records.taken(p)[d], bed.dt * force[3 * p + d], 1e-18);
      sum[d] += bed.dt * force[3 * p + d];
    }
  }
  EXPECT_NEAR((bed.applied.reacting - sum).norm(), 0.0, 1e-13 * sum.norm());
  EXPECT_NEAR(bed.applied.exchanged / sum.lpNorm<1>(), 1.0, 1e-13);
}

// The host's step: v <- v + dt f / m.
TEST(particle_exchange,
     brings_a_particle_of_short_relaxation_time_to_the_gas_velocity_and_not_beyond) {
  for (const double ratio : {1e-4, 1e-2, 1.0, 1e3, 1e6}) {  // step over relaxation time
    Bed bed;
    for (int d = 0; d < 3; ++d) bed.velocity[d].fill(2.0);
    const Effects effects = parse_effects({"drag", "koch_hill"}, "test");
    for (double& v : bed.cloud.velocity) v = -1.0;
    ExchangeRecords records = bed.couple(effects);
    for (std::size_t p = 0; p < records.size(); ++p)
      bed.cloud.mass[p] = records.K(p) * bed.dt / ratio;
    const auto force = bed.apply(effects, records, 0.0);
    for (std::size_t p = 0; p < records.size(); ++p)
      for (int d = 0; d < 3; ++d) {
        const double v = -1.0 + bed.dt * force[3 * p + d] / bed.cloud.mass[p];
        // The exact solution of m dv/dt = K (u - v); the force is a difference of greater ones.
        const double round_off = 3e-12 + 1e-15 * ratio;
        EXPECT_NEAR(v, 2.0 - 3.0 * std::exp(-ratio), round_off) << ratio;
        EXPECT_LE(v, 2.0 + round_off);
      }
  }
}

TEST(particle_exchange, a_light_particle_falls_at_its_terminal_velocity_whatever_the_step) {
  Bed bed;
  for (int d = 0; d < 3; ++d) bed.velocity[d].fill(0.0);
  const Effects effects = parse_effects({"drag", "koch_hill"}, "test");
  for (double& v : bed.cloud.velocity) v = 0.0;
  ExchangeRecords records = bed.couple(effects);
  const double weight = -1e-9;
  for (std::size_t p = 0; p < records.size(); ++p) bed.cloud.mass[p] = 1e-3 * records.K(p) * bed.dt;
  const auto force = bed.apply(effects, records, weight);
  for (std::size_t p = 0; p < records.size(); ++p) {
    const double v = bed.dt * force[3 * p] / bed.cloud.mass[p];
    EXPECT_NEAR(v * records.K(p) / weight, 1.0, 1e-9);
  }
}

TEST(particle_exchange, names_the_field_that_the_gas_did_not_return) {
  Bed bed;
  ParticleWeights weights;
  weights.find(bed.cloud.view(), VoidFractionCentre{}, bed.frame);
  const Effects effects = parse_effects({"pressure_gradient"}, "test");
  ExchangeRecords records(effects.layout(false));
  records.resize(bed.cloud.radius.size());
  try {
    set_gas_at_particles(bed.cloud.view(), weights, effects, air, FieldStore(), 1e-4, records);
    FAIL() << "an absent field was accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("pressure_gradient"), std::string::npos);
  }
}

TEST(particle_exchange, polydisperse_changes_nothing_in_a_bed_of_one_size) {
  Bed bed;
  for (double& r : bed.cloud.radius) r = cloud_radius;
  bed.sauter_diameter = 2.0 * cloud_radius;
  const ExchangeRecords one = bed.couple(parse_effects({"drag", "beetstra"}, "test"));
  const ExchangeRecords mixture =
      bed.couple(parse_effects({"drag", "beetstra", "polydisperse"}, "test"));
  for (std::size_t p = 0; p < one.size(); ++p) EXPECT_NEAR(one.K(p) / mixture.K(p), 1.0, 1e-13);
}

// K(d) = y^2 K(d_s), y = d / d_s: with it a bed of any mixture has the drag of the bed of d_s.
TEST(particle_exchange, polydisperse_bed_has_the_drag_of_the_bed_of_its_sauter_diameter) {
  Bed bed;
  double volume = 0.0;
  double surface = 0.0;
  for (auto& component : bed.velocity) component.fill(1.0);
  for (double& v : bed.cloud.velocity) v = 0.0;
  for (const double r : bed.cloud.radius) {
    volume += sphere_volume(r);
    surface += sphere_surface(r);
  }
  bed.sauter_diameter = 6.0 * volume / surface;
  const Effects effects = parse_effects({"drag", "beetstra", "polydisperse"}, "test");
  const ExchangeRecords mixture = bed.couple(effects);
  double sum = 0.0;
  for (std::size_t p = 0; p < mixture.size(); ++p) sum += mixture.K(p);
  const double one =
      DragBeetstra::coefficient(air, bed.void_fraction, Vec3::Ones().norm(), bed.sauter_diameter);
  // As many spheres of d_s as have the same volume.
  EXPECT_NEAR(sum / (one * volume / sphere_volume(0.5 * bed.sauter_diameter)), 1.0, 1e-12);
}

TEST(particle_exchange, counts_particles_in_cells_too_dense_for_drag) {
  Bed bed;
  bed.void_fraction = -0.1;
  bed.couple(parse_effects({"drag", "koch_hill", "void_fraction", "centre"}, "test"));
  EXPECT_EQ(bed.too_dense.too_dense, bed.cloud.radius.size());
  EXPECT_DOUBLE_EQ(bed.too_dense.least_void_fraction, -0.1);
}

TEST(particle_weights, refuse_a_field_of_another_box) {
  Bed bed;
  ParticleWeights weights;
  weights.find(bed.cloud.view(), VoidFractionCentre{}, bed.frame);
  FieldStore other(Effects{}.taken(), bed.frame.tile.grown(1));
  EXPECT_THROW(deposit_solids(bed.cloud.view(), weights, Effects{}, other), Error);
}

TEST(particle_exchange, a_factor_on_drag_multiplies_its_coefficient) {
  Bed bed;
  const auto coefficient = [&](const std::vector<std::string>& words) {
    ExchangeRecords records = bed.couple(parse_effects(words, "test"));
    return records.K(7);
  };
  const double whole = coefficient({"drag", "koch_hill", "self_disturbance", "ignored"});
  EXPECT_DOUBLE_EQ(
      coefficient({"drag", "koch_hill", "drag_factor", "0.4", "self_disturbance", "ignored"}),
      0.4 * whole);
  EXPECT_THROW(coefficient({"drag", "koch_hill", "drag_factor", "-1"}), Error);
  EXPECT_THROW(coefficient({"drag", "koch_hill", "drag_factor"}), Error);
  EXPECT_THROW(coefficient({"drag_factor", "0.5"}), Error);
}

TEST(particle_exchange, of_a_parcel_is_that_of_its_particles) {
  const Effects effects = parse_effects({"drag", "koch_hill", "void_fraction", "trilinear",
                                         "self_disturbance", "ignored", "pressure_gradient"},
                                        "test");
  Bed parcels, copies;
  copies.velocity = parcels.velocity;
  parcels.cloud.parcel_size.assign(parcels.cloud.radius.size(), 3.0);
  const Cloud once = copies.cloud = parcels.cloud;
  copies.cloud.parcel_size.clear();
  for (int copy = 1; copy < 3; ++copy)
    for (std::size_t p = 0; p < once.radius.size(); ++p)
      copies.cloud.add(once.view().x(p), once.view().v(p), once.radius[p], once.mass[p]);

  const auto deposited = [&](const Cloud& cloud, ExchangeRecords records) {
    ParticleWeights weights;
    weights.find(cloud.view(), effects.method, parcels.frame);
    FieldStore fields(effects.taken(), parcels.frame.tile);
    deposit_solids(cloud.view(), weights, effects, fields);
    deposit_drag(cloud.view(), weights, effects, 1.0, 1e-4, fields, records);
    return fields;
  };
  parcels.pressure_gradient = copies.pressure_gradient = Vec3(10.0, -20.0, 30.0);
  ExchangeRecords of_parcels = parcels.couple(effects);
  ExchangeRecords of_copies = copies.couple(effects);
  const auto force = parcels.apply(effects, of_parcels, 1.0);
  const auto force_of_copies = copies.apply(effects, of_copies, 1.0);
  // Of one particle: the same.
  for (std::size_t n = 0; n < force.size(); ++n) EXPECT_EQ(force[n], force_of_copies[n]);
  // Of all: the sums differ in their order only.
  const auto near = [](double a, double b, double scale) { EXPECT_NEAR(a, b, 1e-12 * scale); };
  for (int d = 0; d < 3; ++d) {
    near(parcels.applied.reacting[d], copies.applied.reacting[d], copies.applied.exchanged);
    near(parcels.applied.free[d], copies.applied.free[d], copies.applied.free.norm());
    near(parcels.applied.host[d], copies.applied.host[d], copies.applied.host.norm());
  }
  near(parcels.applied.exchanged, copies.applied.exchanged, copies.applied.exchanged);
  FieldStore a = deposited(parcels.cloud, of_parcels);
  FieldStore b = deposited(copies.cloud, of_copies);
  const auto fields_a = a.components(effects.taken());
  const auto fields_b = b.components(effects.taken());
  for (std::size_t f = 0; f < fields_a.size(); ++f) {
    double scale = 0.0;
    for (const double value : *fields_b[f]) scale = std::max(scale, std::abs(value));
    EXPECT_GT(scale, 0.0);
    for (std::size_t n = 0; n < fields_a[f]->size(); ++n)
      near((*fields_a[f])[n], (*fields_b[f])[n], scale);
  }
  BedMeasures all(2, 0.0, 1.0), each(2, 0.0, 1.0);
  all.add(parcels.cloud.view());
  each.add(copies.cloud.view());
  EXPECT_EQ(all.count(), each.count());
  EXPECT_EQ(all.parcels(), static_cast<double>(once.radius.size()));
  EXPECT_EQ(each.parcels(), each.count());
  near(all.kinetic_energy(), each.kinetic_energy(), each.kinetic_energy());
  near(all.solid_volume(), each.solid_volume(), each.solid_volume());
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
  EXPECT_EQ(still.momentum(), Vec3(6.0, 0.0, 8.0));
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
