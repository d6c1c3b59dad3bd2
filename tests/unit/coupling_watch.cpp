// What the watch over the grains finds, and that one rank's find reaches all.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "coupling/run_watch.h"

namespace gasgrain {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Grains {
  std::vector<double> x, v, f;
  std::vector<double> radius, mass;
  std::vector<int> id;

  explicit Grains(int count) {
    for (int p = 0; p < count; ++p) {
      for (int d = 0; d < 3; ++d) {
        x.push_back(0.1 + 0.01 * p);
        v.push_back(-1.0);
        f.push_back(1e-5);
      }
      radius.push_back(1e-3);
      mass.push_back(1e-6);
      id.push_back(100 + p);
    }
  }
  [[nodiscard]] ParticleView view() const {
    ParticleView view;
    view.count = id.size();
    view.position = x.data();
    view.velocity = v.data();
    view.radius = radius.data();
    view.mass = mass.data();
    return view;
  }
  [[nodiscard]] HostGrains host() const { return {id.data(), f.data()}; }
};

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(run_watch, finds_every_number_that_is_not_finite_and_names_the_grain) {
  Grains grains(5);
  EXPECT_EQ(look_at_state(grains.view(), grains.host()), "");
  for (const double bad : {nan, infinite, -infinite})
    for (int d = 0; d < 3; ++d) {
      for (auto [array, word] : {std::pair{&Grains::x, "the position of grain 103"},
                                 std::pair{&Grains::v, "the velocity of grain 103"},
                                 std::pair{&Grains::f, "the force on grain 103"}}) {
        Grains spoilt = grains;
        (spoilt.*array)[3 * 3 + d] = bad;
        expect_words(look_at_state(spoilt.view(), spoilt.host()), {word, "not a number"});
      }
    }
  EXPECT_EQ(look_at_state(Grains(0).view(), {}), "");
}

HostBox box_of_one_metre() {
  HostBox box;
  box.hi = Vec3::Ones();
  box.own_hi = Vec3(0.5, 1.0, 1.0);
  return box;
}

TEST(run_watch, finds_grains_that_leave_through_a_side_that_is_not_periodic) {
  Grains grains(5);
  EXPECT_EQ(look_for_leavers(grains.view(), grains.host(), box_of_one_metre()).outside, 0);
  grains.x[3 * 2 + 2] = -1e-9;
  grains.x[3 * 4 + 0] = 1.0;  // the upper side is no part of the box
  HostBox box = box_of_one_metre();
  Leavers found = look_for_leavers(grains.view(), grains.host(), box);
  EXPECT_EQ(found.outside, 2);
  expect_words(found.first, {"grain 102 at x = 0.12", "velocity (-1, -1, -1) m/s",
                             "has left the box through z_lo"});
  EXPECT_EQ(found.jumped, "");
  box.periodic = {true, true, true};
  EXPECT_EQ(look_for_leavers(grains.view(), grains.host(), box).outside, 0);
}

TEST(run_watch, finds_grains_that_the_host_cannot_hand_to_a_neighbour) {
  Grains grains(5);
  HostBox box = box_of_one_metre();
  box.hi[0] = 10.0;
  grains.x[3 * 1] = 0.99;  // in the neighbour's part
  EXPECT_EQ(look_for_leavers(grains.view(), grains.host(), box).jumped, "");
  grains.x[3 * 1] = 1.01;  // beyond it
  expect_words(look_for_leavers(grains.view(), grains.host(), box).jumped,
               {"grain 101", "has crossed more than 0.5 m in x"});
  grains.x[3 * 1] = nan;
  const Leavers found = look_for_leavers(grains.view(), grains.host(), box);
  expect_words(found.not_finite, {"the position of grain 101 at x = nan"});
  EXPECT_EQ(found.jumped + found.first, "");
}

TEST(run_watch, a_fault_is_thrown_and_no_fault_is_not) {
  const Communicator self(MPI_COMM_SELF);
  EXPECT_NO_THROW(share_fault(self, ""));
  try {
    share_fault(self, "grain 7 is lost");
    FAIL();
  } catch (const RunFault& fault) {
    EXPECT_STREQ(fault.what(), "grain 7 is lost");
  }
}

TEST(run_watch, a_moment_before_the_gas_says_so) {
  EXPECT_EQ(at({1200, 0.024}), "at step 1200, t = 0.024 s");
  EXPECT_EQ(at({200, -0.01}), "at step 200, 0.01 s before the gas starts");
}

}  // namespace
}  // namespace gasgrain
