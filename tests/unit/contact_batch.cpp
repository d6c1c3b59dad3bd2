// The loops for several contacts at once against the loop that takes one after the other: the same
// forces, torques and histories for every stack, whatever the instruction set.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "fix_cfd_coupling/dem_physics/contact/contact_stacks.h"
#include "fix_cfd_coupling/dem_physics/contact/stacks_in_lanes.h"
#include "tests/properties/silent_host.h"

namespace gasgrain::contact {
namespace {

// The order of sums and fused products differ, nothing else.
constexpr double round_off = 1e-12;

class Scene : public SilentHost {
 public:
  explicit Scene(int types) : types_(types) {}
  int types() const override { return types_; }
  std::optional<PairTable<double>> pairs(const char* name) const override {
    static const std::map<std::string, double> first = {{"coefficientRestitution", 0.6},
                                                        {"coefficientFriction", 0.2},
                                                        {"coefficientRollingFriction", 0.1},
                                                        {"coefficientRollingViscousDamping", 0.3},
                                                        {"FluidViscosity", 1e-3},
                                                        {"CriticalStokes", 0.01},
                                                        {"MaximumRestitution", 0.7}};
    const auto at = first.find(name);  // others are stiffness and damping
    PairTable<double> table(types_);
    for (int i = 1; i <= types_; ++i)
      for (int j = 1; j <= types_; ++j)
        table(i, j) = (at != first.end() ? at->second : 1e4) * (1.0 + 0.05 * (i + j - 2));
    return table;
  }
  std::optional<std::vector<double>> per_type(const char* name) const override {
    const bool stiffness = std::string(name) == "youngsModulus";
    std::vector<double> values(types_ + 1);
    for (int i = 1; i <= types_; ++i) values[i] = stiffness ? 4e6 + 1e6 * i : 0.2 + 0.05 * i;
    return values;
  }
  std::optional<double> scalar(const char*) const override { return 0.5; }

 private:
  int types_;
};

// All words as they are by themselves, or all of them the other way round.
class Words : public LawWords {
 public:
  explicit Words(bool turned) : turned_(turned) {}
  void on_off(const char*, bool& value, bool by_default) override { value = by_default != turned_; }
  void number(const char*, double& value, double by_default) override { value = by_default; }

 private:
  bool turned_;
};

struct Told : ContactObserver {
  void acts(int i, int j, const Triple& force, const Triple& delta) override {
    contacts[{i, j}] = {force, delta};
  }
  std::map<std::pair<int, int>, std::pair<Triple, Triple>> contacts;
};

// A cloud of grains, most of them in touch with some others, on the way into and out of contact.
class Cloud {
 public:
  static constexpr int owned = 300, all = 330, width = 6;

  explicit Cloud(int types) : force(all), torque(all) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const auto triple = [&](double most) {
      return std::array<double, 3>{most * (2.0 * share(random) - 1.0),
                                   most * (2.0 * share(random) - 1.0),
                                   most * (2.0 * share(random) - 1.0)};
    };
    for (int k = 0; k < all; ++k) {
      x.push_back(triple(0.006));
      v.push_back(triple(0.3));
      spin.push_back(triple(100.0));
      radius.push_back(0.0008 + 0.0004 * share(random));
      mass.push_back(4.0 / 3.0 * pi * 2500.0 * std::pow(radius.back(), 3));
      body_mass.push_back(k % 17 == 3 ? 1e-4 : 0.0);
      type.push_back(1 + k % types);
      mask.push_back(k % 13 == 5 ? 3 : 1);
    }
    neighbours.resize(all);
    in_use.resize(all);
    rows.resize(all);
    for (int i = 0; i < owned; ++i)
      for (int j = i + 1; j < all; ++j) {
        double square = 0.0;
        for (int d = 0; d < 3; ++d) square += std::pow(x[i][d] - x[j][d], 2);
        if (square > std::pow(1.3 * (radius[i] + radius[j]), 2)) continue;
        neighbours[i].push_back(j);
        in_use[i].push_back(share(random) < 0.7 ? 1 : 0);
        for (int n = 0; n < width; ++n)
          rows[i].push_back(in_use[i].back() != 0 ? 1e-7 * (2.0 * share(random) - 1.0) : 0.0);
      }
  }

  Grains grains(const Scene& scene, bool updates) {
    const auto vectors = [](auto& of) { return reinterpret_cast<double(*)[3]>(of.data()); };
    return {vectors(x),  vectors(v),  vectors(spin),    radius.data(),    mass.data(),
            type.data(), mask.data(), vectors(force),   vectors(torque),  owned,
            false,       2,           body_mass.data(), scene.timestep(), 0,
            updates};
  }

  // `flags_apart`: whether a row is in use does not stand in the row.
  void act_at_wall(ContactStack& stack, const Scene& scene, const PrimitiveWall& shape,
                   int material, bool flags_apart, ContactObserver* told) {
    std::vector<int> near, uses;
    std::vector<double*> values;
    for (int i = 0; i < owned; ++i) {
      at_wall[i].resize(width + 1, 1e-7);  // touched before, all of them
      values.push_back(at_wall[i].data());
      if (i % 5 == 0) continue;
      near.push_back(i);
      uses.push_back(1);
    }
    const bool remembers = !stack.history().empty();
    stack.wall(grains(scene, true),
               {static_cast<int>(near.size()), near.data(), remembers ? values.data() : nullptr,
                remembers && flags_apart ? uses.data() : nullptr},
               shape, material, told);
  }

  void act(ContactStack& stack, const Scene& scene, bool updates, ContactObserver* told) {
    std::vector<int> numbers, counts;
    std::vector<const int*> first;
    std::vector<int*> uses;
    std::vector<double*> values;
    for (int i = 0; i < all; ++i) {
      if (i < owned) numbers.push_back(i);
      counts.push_back(static_cast<int>(neighbours[i].size()));
      first.push_back(neighbours[i].data());
      uses.push_back(in_use[i].data());
      values.push_back(rows[i].data());
    }
    const bool remembers = !stack.history().empty();
    stack.pairs(grains(scene, updates), {owned, numbers.data(), counts.data(), first.data(), ~0},
                remembers ? ContactRows{uses.data(), values.data(), width} : ContactRows{}, told);
  }

  std::vector<std::array<double, 3>> x, v, spin, force, torque;
  std::vector<double> radius, mass, body_mass;
  std::vector<int> type, mask;
  std::vector<std::vector<int>> neighbours, in_use;
  std::vector<std::vector<double>> rows, at_wall = std::vector<std::vector<double>>(owned);
};

// Greatest difference, of the greatest value.
template <class Table>
double difference(const Table& one, const Table& other) {
  double greatest = 0.0, difference = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    for (std::size_t d = 0; d < one[k].size(); ++d) {
      greatest = std::max(greatest, std::abs(one[k][d]));
      // not a number is a difference too
      const double here = std::abs(one[k][d] - other[k][d]);
      if (!(here <= difference)) difference = here;
    }
  return greatest > 0.0 ? difference / greatest : difference;
}

std::string text_of(const StackName& stack) {
  std::string name = stack.normal + "_" + stack.tangential + "_" + stack.rolling;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::vector<StackName> names() {
  std::vector<StackName> all;
  for (const char* normal : {"hertz", "hooke", "hertz/stiffness", "hooke/stiffness"})
    for (const char* tangential : {"history", "no_history"})
      for (const char* rolling : {"off", "cdt", "epsd", "epsd2"})
        all.push_back({normal, tangential, rolling});
  all.push_back({"hertz/stiffness", "damped_history"});
  all.push_back({"hooke/stiffness", "damped_history"});
  return all;
}

class contact_batch : public testing::TestWithParam<StackName> {};

TEST_P(contact_batch, every_instruction_set_gives_the_forces_of_one_contact_after_the_other) {
  if (instruction_sets_here().size() == 1) GTEST_SKIP() << "this machine has no vectors for lanes";
  for (const int types : {1, 3})
    for (const bool turned : {false, true})
      for (const bool updates : {true, false}) {
        const Scene scene(types);
        std::map<InstructionSet, Cloud> clouds;
        std::map<InstructionSet, Told> told;
        for (const auto set : instruction_sets_here()) {
          const auto stack = ContactStacks::known().make(GetParam(), false);
          Words words(turned);
          stack->words(words);
          Scene host(types);
          stack->connect(GetParam(), [&](const std::string&, int) -> ContactHost& { return host; });
          stack->set_instructions(set);
          ASSERT_EQ(stack->instructions(), set);
          Cloud& cloud = clouds.emplace(set, Cloud(types)).first->second;
          for (int step = 0; step < 2; ++step) cloud.act(*stack, scene, updates, &told[set]);
        }
        const Cloud& expected = clouds.at(InstructionSet::portable);
        const Told& expected_told = told.at(InstructionSet::portable);
        ASSERT_GT(expected_told.contacts.size(), 300U);
        for (const auto& [set, cloud] : clouds) {
          EXPECT_LT(difference(expected.force, cloud.force), round_off) << name_of(set);
          EXPECT_LT(difference(expected.torque, cloud.torque), round_off) << name_of(set);
          EXPECT_LT(difference(expected.rows, cloud.rows), round_off) << name_of(set);
          EXPECT_EQ(expected.in_use, cloud.in_use) << name_of(set);
          ASSERT_EQ(told.at(set).contacts.size(), expected_told.contacts.size());
          for (const auto& [pair, what] : told.at(set).contacts) {
            const auto& [force, delta] = expected_told.contacts.at(pair);
            EXPECT_LT((what.first - force).norm(), round_off * (1e-3 + force.norm()));
            EXPECT_LT((what.second - delta).norm(), round_off * delta.norm());
          }
        }
      }
}

TEST_P(contact_batch, every_instruction_set_gives_the_forces_of_walls_one_after_the_other) {
  PrimitiveWall plane, cylinder;
  plane.axis = 1;
  plane.place = -0.005;
  plane.velocity = {0.1, 0.0, -0.2};
  cylinder.axis = 2;
  cylinder.round = true;
  cylinder.radius = 0.0055;
  cylinder.centre = {0.0003, -0.0002};
  for (const int types : {1, 3})
    for (const bool flags_apart : {true, false}) {
      const Scene scene(types);
      std::map<InstructionSet, Cloud> clouds;
      std::map<InstructionSet, Told> told;
      for (const auto set : instruction_sets_here()) {
        const auto stack = ContactStacks::known().make(GetParam(), true);
        Words words(false);
        stack->words(words);
        Scene host(types);
        stack->connect(GetParam(), [&](const std::string&, int) -> ContactHost& { return host; });
        stack->set_instructions(set);
        Cloud& cloud = clouds.emplace(set, Cloud(types)).first->second;
        for (const auto& shape : {plane, cylinder, plane})
          cloud.act_at_wall(*stack, scene, shape, types, flags_apart, &told[set]);
      }
      const Cloud& expected = clouds.at(InstructionSet::portable);
      const Told& expected_told = told.at(InstructionSet::portable);
      ASSERT_GT(expected_told.contacts.size(), 30U);
      for (const auto& [set, cloud] : clouds) {
        EXPECT_LT(difference(expected.force, cloud.force), round_off) << name_of(set);
        EXPECT_LT(difference(expected.torque, cloud.torque), round_off) << name_of(set);
        EXPECT_LT(difference(expected.at_wall, cloud.at_wall), round_off) << name_of(set);
        ASSERT_EQ(told.at(set).contacts.size(), expected_told.contacts.size());
        for (const auto& [pair, what] : told.at(set).contacts) {
          const auto& [force, delta] = expected_told.contacts.at(pair);
          EXPECT_LT((what.first - force).norm(), round_off * (1e-3 + force.norm()));
          EXPECT_LT((what.second - delta).norm(), round_off * delta.norm());
        }
      }
    }
}

TEST_P(contact_batch, contacts_that_graze_have_finite_forces_with_every_instruction_set) {
  for (const auto set : instruction_sets_here()) {
    const auto stack = ContactStacks::known().make(GetParam(), false);
    Words words(false);
    stack->words(words);
    Scene scene(1);
    stack->connect(GetParam(), [&](const std::string&, int) -> ContactHost& { return scene; });
    stack->set_instructions(set);
    // Pairs that overlap by a rounding error or are apart by one.
    Cloud cloud(1);
    std::mt19937 random(11);
    std::normal_distribution<double> way;
    for (int round = 0; round < 100; ++round) {
      for (int i = 0; i < Cloud::owned; i += 2) {
        const Vec3 n = Vec3(way(random), way(random), way(random)).normalized();
        for (int d = 0; d < 3; ++d)
          cloud.x[i + 1][d] = cloud.x[i][d] + (cloud.radius[i] + cloud.radius[i + 1]) * n[d];
        cloud.neighbours[i] = {i + 1};
        cloud.neighbours[i + 1].clear();
        cloud.in_use[i] = {0};
        cloud.rows[i].assign(Cloud::width, 0.0);
      }
      cloud.act(*stack, scene, true, nullptr);
    }
    for (int i = 0; i < Cloud::owned; ++i)
      for (int d = 0; d < 3; ++d) {
        ASSERT_TRUE(std::isfinite(cloud.force[i][d])) << name_of(set);
        ASSERT_TRUE(std::isfinite(cloud.torque[i][d])) << name_of(set);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(all_stacks, contact_batch, testing::ValuesIn(names()),
                         [](const auto& stack) { return text_of(stack.param); });

TEST(contact_batch_list, the_number_of_remembered_values_is_that_of_the_history) {
#define CHECK_STACK(Normal, Tangential, Rolling)                                    \
  EXPECT_EQ(Tangential::remembers, static_cast<int>(Tangential::history().size())); \
  EXPECT_EQ(Rolling::remembers, static_cast<int>(Rolling::history(false).size()));
  GASGRAIN_STACKS_IN_LANES(CHECK_STACK)
#undef CHECK_STACK
}

}  // namespace
}  // namespace gasgrain::contact
