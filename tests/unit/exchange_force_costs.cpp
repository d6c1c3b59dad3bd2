// The shares that the effects have of the force loop's time.
#include <gtest/gtest.h>

#include "coupling/exchange/applied_forces.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

constexpr GasProperties air{1.2, 1.8e-5};
constexpr double dt = 1e-5;
const std::vector<std::string> many{"drag",         "koch_hill", "pressure_gradient",
                                    "virtual_mass", "basset",    "saffman_mei"};

// Three blocks of particles with something in every record.
struct Bed {
  explicit Bed(const std::vector<std::string>& words, std::size_t count = 1300)
      : effects(parse_effects(words, "test")), records(effects.layout(false)) {
    Random random{3};
    cloud = random_cloud(uneven_box({false, false, false}), count, random);
    records.resize(count);
    for (std::size_t p = 0; p < count; ++p)
      for (int n = 0; n < records.layout().size; ++n) records.row(p)[n] = random.between(0.0, 1e-5);
  }
  std::vector<double> apply(ForceLoop& loop) {
    std::vector<double> force(cloud.velocity.size(), 1e-7);
    std::vector<double> torque(cloud.velocity.size(), 0.0);
    loop.apply(cloud.view(), records, {force.data(), torque.data()}, dt, 1.0);
    return force;
  }

  Effects effects;
  ExchangeRecords records;
  Cloud cloud;
};

TEST(force_costs, the_shares_sum_to_the_whole_loop_whatever_is_on) {
  const std::vector<std::vector<std::string>> scenes{
      {},
      {"drag", "koch_hill"},
      {"pressure_gradient"},
      {"drag", "koch_hill", "momentum_sharing", "scheme_2"},
      {"virtual_mass", "saffman_mei"},
      many};
  for (const auto& words : scenes)
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1300}}) {
      Bed bed(words, count);
      ForceLoop loop(bed.effects, air);
      for (int step = 0; step < 40; ++step) bed.apply(loop);
      const ForceCosts& costs = loop.costs();
      ASSERT_EQ(costs.rows(), bed.effects.names().size() + 1);
      double sum = 0.0;
      for (std::size_t row = 0; row < costs.rows(); ++row) {
        EXPECT_GE(costs.share(row), 0.0);
        sum += costs.share(row);
      }
      EXPECT_NEAR(sum, 1.0, 1e-12) << words.size() << " words, " << count << " particles";
    }
}

// Steady forces are evaluated at couplings; a step only adds their sum.
TEST(force_costs, what_a_step_does_has_a_share_and_what_it_does_not_has_none) {
  Bed bed(many);
  ForceLoop loop(bed.effects, air);
  for (int step = 0; step < 40; ++step) bed.apply(loop);
  const std::vector<std::string> names = bed.effects.names();
  for (std::size_t row = 0; row < names.size(); ++row) {
    if (names[row] == "pressure_gradient") {
      EXPECT_EQ(loop.costs().share(row), 0.0);
    } else if (names[row] != "virtual_mass") {  // a few instructions: the clock may not see them
      EXPECT_GT(loop.costs().share(row), 0.0) << names[row];
    }
  }
  EXPECT_GT(loop.costs().share(loop.costs().row_of_every_step()), 0.0);
}

// A fresh loop times its first step, one that goes on only one in many.
TEST(force_costs, timing_a_step_changes_nothing_of_it) {
  Bed timed(many);
  Bed seldom(many);
  ForceLoop loop(seldom.effects, air);
  for (int step = 0; step < 10; ++step) {
    ForceLoop first(timed.effects, air);
    ASSERT_EQ(timed.apply(first), seldom.apply(loop)) << step;
  }
  for (std::size_t p = 0; p < timed.cloud.radius.size(); ++p)
    for (int n = 0; n < timed.records.layout().size; ++n)
      ASSERT_EQ(timed.records.row(p)[n], seldom.records.row(p)[n]) << p << ' ' << n;
}

}  // namespace
}  // namespace gasgrain
