// The loops over contacts without a host: what two spheres do to each other.
#include "fix_cfd_coupling/dem_physics/contact/contact_loop.h"

#include <gtest/gtest.h>

#include <map>

#include "fix_cfd_coupling/dem_physics/contact/normal_hertz.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_cdt.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_history.h"
#include "tests/properties/silent_host.h"

namespace gasgrain::contact {
namespace {

constexpr double youngs = 5e6, poisson = 0.25, restitution = 0.7, friction = 0.3, rolling = 0.1;
constexpr double round_off = 1e-13;

// Has one type, and the properties above.
class Scene : public SilentHost {
 public:
  int types() const override { return 1; }
  std::optional<PairTable<double>> pairs(const char* name) const override {
    const std::map<std::string, double> values = {{"coefficientRestitution", restitution},
                                                  {"coefficientFriction", friction},
                                                  {"coefficientRollingFriction", rolling}};
    PairTable<double> table(1);
    table(1, 1) = values.at(name);
    return table;
  }
  std::optional<std::vector<double>> per_type(const char* name) const override {
    return std::vector<double>{0.0, std::string(name) == "youngsModulus" ? youngs : poisson};
  }
  std::optional<double> scalar(const char*) const override { return std::nullopt; }
};

template <class Rolling>
class Pair {
 public:
  double x[2][3] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  double v[2][3] = {}, spin[2][3] = {}, force[2][3] = {}, torque[2][3] = {};
  double radius[2] = {0.001, 0.0015}, mass[2] = {1e-5, 3e-5};
  double row[6] = {};
  int in_use = 0;

  explicit Pair(double overlap) {
    x[1][0] = radius[0] + radius[1] - overlap;
    laws().places = {0, 3, 3, 3, 3};
    Scene scene;
    laws().normal.connect(scene);
    laws().tangential.connect(scene);
    laws().rolling.connect(scene);
  }
  void act(double dt = 0.0) {
    for (auto* array : {&force, &torque})
      for (auto& of_grain : *array)
        for (double& value : of_grain) value = 0.0;
    const int type[2] = {1, 1}, mask[2] = {1, 1};
    const Grains grains{x,      v, spin, radius, mass,    type, mask, force,
                        torque, 2, true, 0,      nullptr, dt,   0,    true};
    const int i = 0, j = 1, count[2] = {1, 0};
    const int* first[2] = {&j, nullptr};
    int* uses[2] = {&in_use, nullptr};
    double* rows[2] = {row, nullptr};
    loop_.pairs(grains, {1, &i, count, first, ~0}, {uses, rows, 3}, nullptr);
  }

 private:
  using Laws = ContactLaws<NormalHertz, TangentialHistory, Rolling, CohesionOff>;
  Laws& laws() { return loop_.laws; }
  ContactLoop<Laws> loop_;
};

TEST(contact_loop, a_pair_at_rest_has_the_force_of_hertz) {
  Pair<RollingOff> pair(1e-5);
  pair.act();
  const double k = hertz_stiffness(effective_modulus(youngs, poisson, youngs, poisson),
                                   effective(pair.radius[0], pair.radius[1]));
  const double expected = k * std::pow(1e-5, 1.5);
  EXPECT_NEAR(pair.force[0][0], -expected, 1e-9 * expected);  // the overlap is a difference
  EXPECT_EQ(pair.force[0][1], 0.0);
}

TEST(contact_loop, forces_are_opposite_and_torques_are_those_of_one_force_between_the_centres) {
  Pair<RollingCdt> pair(1e-5);
  const double v[2][3] = {{0.1, 0.2, -0.1}, {-0.1, 0.05, 0.3}};
  const double spin[2][3] = {{10.0, -30.0, 20.0}, {5.0, 40.0, -10.0}};
  for (int n = 0; n < 2; ++n)
    for (int d = 0; d < 3; ++d) {
      pair.v[n][d] = v[n][d];
      pair.spin[n][d] = spin[n][d];
    }
  pair.act(1e-6);
  const Vec3 on_i = vec(pair.force[0]), between = vec(pair.x[0]) - vec(pair.x[1]);
  EXPECT_LT((on_i + vec(pair.force[1])).norm(), round_off * on_i.norm());
  // The angular momentum of both, spins and paths, stays.
  const Vec3 orbital(between[1] * on_i[2] - between[2] * on_i[1],
                     between[2] * on_i[0] - between[0] * on_i[2],
                     between[0] * on_i[1] - between[1] * on_i[0]);
  EXPECT_LT((orbital + vec(pair.torque[0]) + vec(pair.torque[1])).norm(),
            round_off * vec(pair.torque[0]).norm() * 10);
}

TEST(contact_loop, the_forces_are_the_same_for_an_observer_who_moves) {
  Pair<RollingCdt> still(1e-5), moving(1e-5);
  for (Pair<RollingCdt>* pair : {&still, &moving}) {
    pair->v[0][1] = 0.25;
    pair->v[0][0] = 0.125;
    pair->spin[1][2] = 40.0;
  }
  for (auto& v : moving.v) v[1] += 4.0, v[0] -= 2.0;
  still.act(1e-6);
  moving.act(1e-6);
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(still.force[0][d], moving.force[0][d]);
    EXPECT_EQ(still.torque[1][d], moving.torque[1][d]);
  }
}

TEST(contact_loop, friction_holds_by_its_spring_then_slides_at_coulombs_limit) {
  Pair<RollingOff> pair(1e-5);
  pair.v[0][1] = 1e-3;
  pair.act(1e-6);
  const double held = std::abs(pair.force[0][1]), normal = std::abs(pair.force[0][0]);
  EXPECT_LT(held, friction * normal);
  for (int n = 0; n < 20000; ++n) pair.act(1e-6);
  EXPECT_NEAR(std::abs(pair.force[0][1]), friction * std::abs(pair.force[0][0]),
              round_off * normal);
  EXPECT_LT(pair.force[0][1], 0.0);
}

TEST(contact_loop, a_contact_that_opens_forgets_its_spring) {
  Pair<RollingOff> pair(1e-5);
  pair.v[0][1] = 1e-2;
  pair.act(1e-5);
  EXPECT_EQ(pair.in_use, 1);
  EXPECT_NE(pair.row[1], 0.0);
  pair.x[1][0] += 2e-5;
  pair.act(1e-5);
  EXPECT_EQ(pair.in_use, 0);
  EXPECT_EQ(pair.row[1], 0.0);
  EXPECT_EQ(pair.force[0][0], 0.0);
}

TEST(contact_loop, a_property_outside_of_its_range_is_refused_with_what_is_allowed) {
  const Scene scene;
  try {
    pairs_in(scene, {"coefficientFriction", "", 0.5, 1.0});
    FAIL() << "0.3 was taken";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("types 1 and 1 is 0.3; allowed: from 0.5 to 1"),
              std::string::npos);
  }
}

TEST(contact_loop, a_cylinder_pushes_inwards_from_inside_and_outwards_from_outside) {
  PrimitiveWall tube;
  tube.axis = 2;
  tube.round = true;
  tube.radius = 0.01;
  tube.centre = {0.5, 0.25};
  const double inside[3] = {0.509, 0.25, 7.0}, outside[3] = {0.5, 0.2625, 7.0};
  Triple to_grain;
  EXPECT_NEAR(tube.reach(inside, to_grain), 0.001, 1e-15);
  EXPECT_LT(to_grain.x, 0.0);
  EXPECT_NEAR(tube.reach(outside, to_grain), 0.0025, 1e-15);
  EXPECT_GT(to_grain.y, 0.0);
}

}  // namespace
}  // namespace gasgrain::contact
