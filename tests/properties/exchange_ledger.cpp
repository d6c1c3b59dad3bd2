// Momentum balances between gas and particles to round-off, for every drag law and method.
#include <gtest/gtest.h>

#include "coupling/exchange/ledger.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

// A gas that does as it likes with its velocity, but loses K u - S.
class WilfulGas {
 public:
  WilfulGas(const TileFrame& frame, Random& random)
      : velocity(make_vector_field(frame.tile)),
        pressure_gradient(make_vector_field(frame.tile)),
        void_fraction(frame.tile),
        cell_volume_(frame.grid.cell_volume()),
        random_(random) {
    random_.fill(void_fraction, 0.4, 0.95);
  }

  // Returns the drag impulse it gave over the interval.
  Vec3 advance(const Array3<double>& K, const VectorField& S, double interval) {
    Vec3 given = Vec3::Zero();
    for (int d = 0; d < 3; ++d) {
      random_.fill(velocity[d], -3.0, 5.0);
      random_.fill(pressure_gradient[d], -5e3, 5e3);
      for (std::size_t n = 0; n < K.size(); ++n)
        given[d] += cell_volume_ * (K[n] * velocity[d][n] - S[d][n]) * interval;
    }
    random_.fill(void_fraction, 0.4, 0.95);
    return given;
  }

  VectorField velocity;
  VectorField pressure_gradient;
  Array3<double> void_fraction;

 private:
  double cell_volume_;
  Random& random_;
};

// Couplings of different lengths, DEM steps with ever new particle velocities, particles that come
// and go. Returns the ledger after `couplings` and as many DEM steps more as asked for.
Ledger run(const Effects& effects, int couplings, int steps_after_last) {
  const BoxGrid grid = uneven_box({true, false, false});
  const TileFrame frame = whole_frame(grid, effects.method);
  Random random(7);
  Cloud cloud = random_cloud(grid, 300, random);
  std::vector<ExchangeRecord> records(cloud.radius.size());
  WilfulGas gas(frame, random);
  Ledger ledger(effects);
  ParticleWeights weights;

  for (int coupling = 0; coupling < couplings; ++coupling) {
    const double interval = random.between(1e-4, 3e-4);
    weights.find(cloud.view(), effects.method, frame);
    refresh_drag(cloud.view(), weights, *effects.drag, {1.2, 1.8e-5}, gas.void_fraction,
                 gas.velocity, records.data());
    Array3<double> K(frame.tile);
    VectorField S = make_vector_field(frame.tile);
    deposit_drag(cloud.view(), weights, records.data(), grid.cell_volume(), interval, K, S);
    ledger.add_given(gas.advance(K, S, interval));
    ledger.add_steady_work(set_records(cloud.view(), weights, effects,
                                       {&gas.velocity, &gas.pressure_gradient}, interval,
                                       records.data()));

    const int steps = coupling + 1 == couplings ? steps_after_last : 10;
    for (int step = 0; step < steps; ++step) {
      for (double& v : cloud.velocity) v += random.between(-0.5, 0.5);
      std::vector<double> force(cloud.velocity.size(), 0.0);
      ledger.add_taken(
          apply_forces(cloud.view(), effects, records.data(), force.data(), interval / 10.0));
      if (step == 4 && coupling % 3 == 1) {
        ledger.add_left(carry(records.back()));
        records.pop_back();
        cloud.remove_last();
      }
    }
    if (coupling % 5 == 2) {
      cloud.add(random.vector(grid.lo, grid.hi), random.vector(1.0), cloud_radius);
      records.emplace_back();
    }
  }
  ledger.set_outstanding(outstanding_carry(records.size(), records.data()));
  return ledger;
}

TEST(ledger, closes_for_every_drag_law_and_void_fraction_method) {
  for_each_choice<DragModel>([](auto law) {
    for_each_choice<VoidFractionMethod>([&](auto method) {
      const Effects effects = parse_effects({"drag", std::string(law.name), "void_fraction",
                                             std::string(method.name), "pressure_gradient"},
                                            "test");
      // At a coupling, and in the middle of an interval.
      for (const int steps : {0, 5, 10}) {
        const Ledger ledger = run(effects, 20, steps);
        // Sums of some 1e5 terms of either sign.
        EXPECT_LT(ledger.residual(), 1e-13) << effects.text();
        EXPECT_GT(ledger.outstanding().norm(), 1e-6 * ledger.exchanged())
            << "the carry was never put to the test";
        EXPECT_GT(ledger.left().norm(), 0.0);
        EXPECT_TRUE(ledger.idle_effects().empty());
      }
    });
  });
}

TEST(ledger, shows_a_particle_that_left_without_its_carry) {
  const Effects effects = parse_effects({"drag", "koch_hill"}, "test");
  Ledger ledger = run(effects, 20, 10);
  ledger.add_left(-ledger.left());
  EXPECT_GT(ledger.residual(), 1e-10);
}

TEST(ledger, sums_over_ranks_and_survives_a_restart_by_its_values) {
  const Effects effects = parse_effects({"drag", "koch_hill", "pressure_gradient"}, "test");
  const Ledger one = run(effects, 3, 10);
  Ledger both(effects);
  std::vector<double> values = one.values();
  for (double& value : values) value *= 2.0;
  both.set_values(values);
  EXPECT_EQ(both.given(), 2.0 * one.given());
  EXPECT_EQ(both.residual(), one.residual());
  EXPECT_EQ(both.values(), values);
  EXPECT_THROW(both.set_values({1.0, 2.0}), Error);
}

TEST(ledger, names_the_effects_that_did_nothing) {
  const Effects effects = parse_effects({"drag", "koch_hill", "pressure_gradient"}, "test");
  Ledger ledger(effects);
  EXPECT_EQ(ledger.residual(), 0.0);
  EXPECT_EQ(ledger.idle_effects(), (std::vector<std::string>{"drag", "pressure_gradient"}));
  EXPECT_NE(ledger.text().find("pressure_gradient"), std::string::npos);
  ledger.add_taken({Vec3(0.0, 0.0, 1.0), 1.0});
  EXPECT_EQ(ledger.idle_effects(), std::vector<std::string>{"pressure_gradient"});
  EXPECT_TRUE(Ledger(Effects{}).idle_effects().empty());
}

TEST(ledger, has_as_many_values_as_columns) {
  EXPECT_EQ(Ledger::column_names().size(), Ledger(Effects{}).column_values().size());
}

}  // namespace
}  // namespace gasgrain
