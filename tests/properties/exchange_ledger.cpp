// Momentum balances between gas and particles to round-off, for every drag law and method.
#include <gtest/gtest.h>

#include "coupling/exchange/ledger.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

// A gas that does as it likes with its fields, but loses K u - S.
class WilfulGas {
 public:
  WilfulGas(const Effects& effects, const TileFrame& frame, Random& random)
      : fields(effects.lent().united(effects.taken()), frame.tile),
        effects_(effects),
        cell_volume_(frame.grid.cell_volume()),
        random_(random) {
    random_.fill(fields.scalar(GasField::void_fraction), 0.4, 0.95);
  }

  // Returns the impulse it gave over the interval.
  Vec3 advance(double interval) {
    for (Array3<double>* field : fields.components(effects_.lent()))
      random_.fill(*field, -3.0, 5.0);
    random_.fill(fields.scalar(GasField::void_fraction), 0.4, 0.95);
    Vec3 given = Vec3::Zero();
    const Array3<double>& K = fields.scalar(GasField::drag_coefficient);
    for (int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < K.size(); ++n)
        given[d] += cell_volume_ * interval *
                    (K[n] * fields.vector(GasField::velocity)[d][n] -
                     fields.vector(GasField::drag_source)[d][n]);
    return given;
  }

  FieldStore fields;

 private:
  Effects effects_;
  double cell_volume_;
  Random& random_;
};

constexpr GasProperties air{1.2, 1.8e-5};

// Couplings of different lengths, DEM steps with ever new particle velocities, particles that come
// and go. Returns the ledger after `couplings` and as many DEM steps more as asked for.
Ledger run(const Effects& effects, int couplings, int steps_after_last, bool parcels = false) {
  const BoxGrid grid = uneven_box({true, false, false});
  const TileFrame frame = whole_frame(grid, effects.method);
  Random random(7);
  Cloud cloud = random_cloud(grid, 300, random);
  if (parcels)
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      cloud.parcel_size.push_back(random.between(0.5, 1000.0));
  ExchangeRecords records(effects.layout(false));
  records.resize(cloud.radius.size());
  WilfulGas gas(effects, frame, random);
  Ledger ledger(effects);
  ForceLoop forces(effects, air);
  ParticleWeights weights;

  for (int coupling = 0; coupling < couplings; ++coupling) {
    const double interval = random.between(1e-4, 3e-4);
    weights.find(cloud.view(), effects.method, frame);
    refresh_drag(cloud.view(), weights, effects, air, gas.fields, records);
    for (Array3<double>* field : gas.fields.components(effects.taken())) field->fill(0.0);
    deposit_drag(cloud.view(), weights, effects, grid.cell_volume(), interval, gas.fields, records);
    ledger.add_given(gas.advance(interval));
    book_expected(cloud.view(), weights, effects, gas.fields, interval, records);
    ledger.add_work(
        set_gas_at_particles(cloud.view(), weights, effects, air, gas.fields, interval, records));

    const int steps = coupling + 1 == couplings ? steps_after_last : 10;
    for (int step = 0; step < steps; ++step) {
      for (double& v : cloud.velocity) v += random.between(-0.5, 0.5);
      std::vector<double> force(cloud.velocity.size(), 1e-3);
      std::vector<double> torque(cloud.velocity.size(), 0.0);
      forces.apply(cloud.view(), records, {force.data(), torque.data()}, 2e-5, 1.0);
      if (step == 4 && coupling % 3 == 1) {
        ledger.add_left(cloud.view().N(records.size() - 1) * records.carry(records.size() - 1));
        records.resize(records.size() - 1);
        cloud.remove_last();
      }
    }
    if (coupling % 5 == 2) {
      cloud.add(random.vector(grid.lo, grid.hi), random.vector(1.0), cloud_radius);
      records.resize(records.size() + 1);
    }
  }
  ledger.add_taken(forces.applied());
  ledger.set_outstanding(outstanding_carry(cloud.view(), records));
  return ledger;
}

// All forces of the LIST, drag and one way of sharing.
Effects every_force(std::string_view drag, std::string_view method, std::string_view sharing) {
  std::vector<std::string> words{"drag",
                                 std::string(drag),
                                 "void_fraction",
                                 std::string(method),
                                 "momentum_sharing",
                                 std::string(sharing)};
  for (const std::string& force : choice_names<Force>()) {
    words.push_back(force);
    if (force == "lorentz")
      for (const char* word : {"charge", "1e-6", "electric", "10", "20", "-5"})
        words.push_back(word);
  }
  return parse_effects(words, "test");
}

TEST(ledger, closes_for_every_drag_law_and_void_fraction_method_with_every_force_on) {
  for_each_choice<DragModel>([](auto law) {
    for_each_choice<VoidFractionMethod>([&](auto method) {
      const Effects effects = every_force(law.name, method.name, "scheme_3");
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

TEST(ledger,
     closes_for_the_ways_of_sharing_that_obey_the_third_law_and_shows_the_one_that_does_not) {
  EXPECT_LT(run(every_force("koch_hill", "trilinear", "scheme_2"), 20, 10).residual(), 1e-13);
  EXPECT_GT(run(every_force("koch_hill", "trilinear", "scheme_1"), 20, 10).residual(), 1e-6);
}

TEST(ledger, closes_for_parcels) {
  for (const std::string method : {"centre", "trilinear", "kernel"}) {
    const Ledger ledger = run(every_force("koch_hill", method, "scheme_3"), 20, 10, true);
    EXPECT_LT(ledger.residual(), 1e-13);
    EXPECT_GT(ledger.left().norm(), 0.0);
  }
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
  ledger.add_work({1.0, 0.0});
  EXPECT_EQ(ledger.idle_effects(), std::vector<std::string>{"pressure_gradient"});
  EXPECT_TRUE(Ledger(Effects{}).idle_effects().empty());
}

TEST(ledger, has_as_many_values_as_columns) {
  const Ledger ledger(parse_effects({"drag", "koch_hill", "pressure_gradient"}, "test"));
  EXPECT_EQ(ledger.column_names().size(), ledger.column_values().size());
}

}  // namespace
}  // namespace gasgrain
