// What holds for every force of the LIST, drag aside, and what each owes to its source.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "coupling/exchange/forces/forces.h"
#include "tests/exchange_lists.h"

namespace gasgrain {
namespace {

const GasProperties air{1.2, 1.8e-5};
const GasProperties unit_gas{1.0, 1.0};

// Some state in which no force vanishes.
GasAtParticle some_gas() {
  GasAtParticle at;
  at.velocity = Vec3(0.3, -0.2, 1.4);
  at.pressure_gradient = Vec3(20.0, -3.0, 900.0);
  at.vorticity = Vec3(40.0, -250.0, 90.0);
  at.acceleration = Vec3(3.0, 17.0, -8.0);
  at.viscous_force = Vec3(0.2, -0.1, 0.4);
  return at;
}

GrainState some_grain() {
  GrainState grain;
  grain.velocity = Vec3(-0.1, 0.5, 0.2);
  grain.angular_velocity = Vec3(100.0, 35.0, -60.0);
  grain.radius = 1.2e-3;
  return grain;
}

// Force or torque at a moment. A force of acceleration acts on a particle that is held, one with a
// memory on a particle that has been held for three steps.
template <class Chosen>
Vec3 acting(const Chosen& chosen, const GasProperties& gas, const GasAtParticle& at,
            const GrainState& grain) {
  if constexpr (Chosen::kind == ForceKind::steady) {
    return chosen.force(gas, at, grain.radius);
  } else if constexpr (Chosen::kind == ForceKind::motion) {
    return chosen.force(gas, at, grain);
  } else if constexpr (Chosen::kind == ForceKind::torque) {
    return chosen.torque(gas, at, grain);
  } else if constexpr (Chosen::kind == ForceKind::added_mass) {
    return chosen.added_mass(gas, grain.radius) * at.acceleration;
  } else {
    static const typename Chosen::Memory memory(1e-5, 1e-2, 0.01);
    std::vector<double> state(memory.state_size(), 0.0);
    for (int n = 0; n < 3; ++n) memory.advance(state.data(), at.acceleration);
    return memory.added_mass(gas, grain.radius) * at.acceleration +
           memory.history(gas, grain.radius, state.data());
  }
}

// Of a force with parameters, an object that acts.
template <class Chosen>
Chosen example() {
  return {};
}
template <>
ForceLorentz example() {
  ForceLorentz lorentz;
  lorentz.charge = 1e-9;
  lorentz.electric = Vec3(1e3, -2e3, 5e2);
  lorentz.magnetic = Vec3(0.1, 0.4, -0.2);
  return lorentz;
}
ForceLorentz turned(const ForceLorentz& lorentz, const Eigen::Matrix3d& turn, double axial) {
  ForceLorentz result = lorentz;
  result.electric = turn * lorentz.electric;
  result.magnetic = axial * turn * lorentz.magnetic;
  return result;
}
template <class Chosen>
Chosen turned(const Chosen& chosen, const Eigen::Matrix3d&, double) {
  return chosen;
}

// The same state seen in a turned or mirrored frame; `axial`: -1 for a mirror, which turns the
// vectors of rotation round once more.
GasAtParticle turned(const GasAtParticle& at, const Eigen::Matrix3d& turn, double axial) {
  GasAtParticle result;
  result.velocity = turn * at.velocity;
  result.pressure_gradient = turn * at.pressure_gradient;
  result.vorticity = axial * turn * at.vorticity;
  result.acceleration = turn * at.acceleration;
  result.viscous_force = turn * at.viscous_force;
  return result;
}
GrainState turned(const GrainState& grain, const Eigen::Matrix3d& turn, double axial) {
  GrainState result = grain;
  result.velocity = turn * grain.velocity;
  result.angular_velocity = axial * turn * grain.angular_velocity;
  return result;
}

template <class Chosen>
class force : public testing::Test {};
TYPED_TEST_SUITE(force, ListedTypes<Force>::type, ListedName);

TYPED_TEST(force, acts) {
  EXPECT_GT(acting(example<TypeParam>(), air, some_gas(), some_grain()).norm(), 0.0);
}

TYPED_TEST(force, turns_with_the_frame_and_is_mirrored_with_it) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Vec3(1.0, -1.0, 1.0).asDiagonal();
  const auto chosen = example<TypeParam>();
  const Vec3 before = acting(chosen, air, some_gas(), some_grain());
  for (const double axial : {1.0, -1.0}) {
    const Eigen::Matrix3d frame = axial < 0.0 ? Eigen::Matrix3d(turn * mirror) : turn;
    const Vec3 after = acting(turned(chosen, frame, axial), air, turned(some_gas(), frame, axial),
                              turned(some_grain(), frame, axial));
    const double sign = TypeParam::kind == ForceKind::torque ? axial : 1.0;
    EXPECT_NEAR((after - sign * frame * before).norm() / before.norm(), 0.0, 1e-13);
  }
}

TYPED_TEST(force, is_the_same_for_observers_in_uniform_motion) {
  const auto chosen = example<TypeParam>();
  GasAtParticle at = some_gas();
  GrainState grain = some_grain();
  const Vec3 before = acting(chosen, air, at, grain);
  const Vec3 boost(3.0, -7.0, 11.0);
  at.velocity += boost;
  grain.velocity += boost;
  Vec3 after = acting(chosen, air, at, grain);
  // E and B are those of one observer.
  if constexpr (std::is_same_v<TypeParam, ForceLorentz>)
    after -= chosen.charge * boost.cross(chosen.magnetic);
  EXPECT_NEAR((after - before).norm() / before.norm(), 0.0, 1e-13);
}

TYPED_TEST(force, needs_the_fields_it_asks_for_and_no_others) {
  const auto chosen = example<TypeParam>();
  const struct {
    GasField field;
    Vec3 GasAtParticle::*value;
  } fields[] = {{GasField::velocity, &GasAtParticle::velocity},
                {GasField::pressure_gradient, &GasAtParticle::pressure_gradient},
                {GasField::vorticity, &GasAtParticle::vorticity},
                {GasField::acceleration, &GasAtParticle::acceleration},
                {GasField::viscous_force, &GasAtParticle::viscous_force}};
  for (const auto& [field, value] : fields) {
    GasAtParticle at = some_gas();
    at.*value = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(acting(chosen, air, at, some_grain()).allFinite(), !TypeParam::lent().has(field))
        << info(field).name;
  }
}

TYPED_TEST(force, is_finite_for_any_gas_and_vanishes_in_gas_that_moves_with_the_grain) {
  const auto chosen = example<TypeParam>();
  const std::vector<double> scales{0.0, 1e-300, 1e-160, 1e-30, 1e-9, 1e-3, 1.0, 100.0};
  for (const double radius : {1e-7, 1e-3, 0.05})
    for (const double slip : scales)
      for (const double spin : scales)
        for (const double turn : scales) {
          GasAtParticle at = some_gas();
          GrainState grain;
          grain.radius = radius;
          at.velocity = slip * Vec3(0.6, -0.3, 0.7);
          at.vorticity = 1e4 * turn * Vec3(0.1, 0.9, 0.4);
          grain.angular_velocity = 1e4 * spin * Vec3(-0.8, 0.5, 0.3);
          ASSERT_TRUE(acting(chosen, air, at, grain).allFinite())
              << "radius " << radius << ", slip " << slip << ", spin " << spin << ", turn " << turn;
        }
  if (std::is_same_v<TypeParam, ForceLorentz>) return;
  GrainState grain = some_grain();
  GasAtParticle at;
  at.velocity = grain.velocity;
  grain.angular_velocity.setZero();
  EXPECT_EQ(acting(chosen, air, at, grain), Vec3::Zero());
}

GasAtParticle moving(const Vec3& velocity, const Vec3& vorticity) {
  GasAtParticle at;
  at.velocity = velocity;
  at.vorticity = vorticity;
  return at;
}

GrainState spinning(const Vec3& angular_velocity, double radius) {
  GrainState grain;
  grain.angular_velocity = angular_velocity;
  grain.radius = radius;
  return grain;
}

TEST(viscous_stress, is_that_of_gas_in_the_particles_place) {
  GasAtParticle at;
  at.viscous_force = Vec3(1.0, 2.0, -3.0);
  EXPECT_EQ(ForceViscousStress::force(air, at, 0.5), pi / 6.0 * at.viscous_force);
}

TEST(virtual_mass, is_half_of_the_displaced_gas) {
  EXPECT_NEAR(ForceVirtualMass::added_mass(air, 0.5), 0.5 * 1.2 * pi / 6.0, 1e-15);
}

// Saffman (1968): 6.46 mu a^2 U (G / nu)^(1/2), where Re_U << Re_G^(1/2) << 1: here 1e-6, 1e-4.
TEST(saffman_mei, is_saffmans_lift_at_small_reynolds_numbers_towards_the_faster_gas) {
  const double gradient = 1e-8;
  const double slip = 1e-6;
  // u_x = G y, and a particle that is slower.
  const Vec3 lift = ForceSaffmanMei{}.force(
      unit_gas, moving(slip * Vec3::UnitX(), -gradient * Vec3::UnitZ()), spinning({0, 0, 0}, 1.0));
  EXPECT_NEAR(lift.y() / (6.46 * slip * std::sqrt(gradient)), 1.0, 1e-3);
  EXPECT_EQ(lift.x(), 0.0);
  EXPECT_EQ(lift.z(), 0.0);
}

TEST(saffman_mei, has_the_factor_of_mei_1992) {
  EXPECT_EQ(ForceSaffmanMei::over_saffman(0.0, 0.4), 1.0);
  EXPECT_NEAR(ForceSaffmanMei::over_saffman(10.0, 0.1), 0.434124, 1e-6);
  EXPECT_NEAR(ForceSaffmanMei::over_saffman(1.0, 0.4), 0.924783, 1e-6);
  EXPECT_NEAR(ForceSaffmanMei::over_saffman(100.0, 0.1), 0.165703, 1e-6);
}

// In a force: d = 2, slip 5, omega 0.5 in the unit gas are Re = 10, beta = 0.1.
TEST(saffman_mei, forms_its_reynolds_number_and_beta_with_diameter_and_whole_vorticity) {
  const Vec3 lift = ForceSaffmanMei{}.force(
      unit_gas, moving(5.0 * Vec3::UnitX(), -0.5 * Vec3::UnitZ()), spinning({0, 0, 0}, 1.0));
  EXPECT_NEAR(lift.y(), 1.615 * 4.0 * std::sqrt(0.5) * 5.0 * 0.434124, 1e-5);
}

TEST(saffman_mei, jumps_at_re_40_as_stated) {
  const auto jump = [](double beta) {
    return ForceSaffmanMei::over_saffman(40.0 + 1e-9, beta) /
           ForceSaffmanMei::over_saffman(40.0, beta);
  };
  EXPECT_NEAR(jump(0.005), 0.567, 1e-3);
  EXPECT_NEAR(jump(0.1), 0.865, 1e-3);
  EXPECT_NEAR(jump(0.4), 0.935, 1e-3);
}

// It flies along x with backspin: its top, at +y, goes backwards.
TEST(magnus, lifts_a_ball_with_backspin) {
  GrainState ball = spinning(10.0 * Vec3::UnitZ(), 0.02);
  ball.velocity = 5.0 * Vec3::UnitX();
  const Vec3 lift = ForceMagnus{}.force(air, GasAtParticle{}, ball);
  EXPECT_GT(lift.y(), 0.0);
  EXPECT_EQ(lift.x(), 0.0);
}

// Tsuji et al. (1985): a fifth of Rubinow and Keller's pi a^3 rho omega x V for G <= 1, and above
// 0.4 of the dynamic pressure on the cross section, whatever the spin.
TEST(magnus, has_the_coefficient_of_tsuji_1985) {
  const double radius = 0.02;
  GrainState ball = spinning(100.0 * Vec3::UnitZ(), radius);
  ball.velocity = 5.0 * Vec3::UnitX();
  EXPECT_NEAR(ForceMagnus{}.force(air, GasAtParticle{}, ball).y(),
              0.2 * pi * std::pow(radius, 3) * 1.2 * 100.0 * 5.0, 1e-12);
  for (const double rate : {300.0, 3000.0}) {
    ball.angular_velocity = rate * Vec3::UnitZ();
    EXPECT_NEAR(ForceMagnus{}.force(air, GasAtParticle{}, ball).y(),
                0.4 * 0.5 * 1.2 * 25.0 * pi * radius * radius, 1e-12);
  }
}

TEST(magnus, does_not_act_on_a_grain_that_turns_with_the_gas) {
  const Vec3 vorticity(3.0, -4.0, 5.0);
  EXPECT_EQ(
      ForceMagnus{}.force(air, moving(Vec3::UnitX(), vorticity), spinning(0.5 * vorticity, 0.01)),
      Vec3::Zero());
}

TEST(rotation_torque, is_that_of_stokes_for_slow_rotation) {
  const Vec3 rate(1e-3, 2e-3, -1e-3);
  const double radius = 1e-3;
  const double d = 2.0 * radius;
  const Vec3 torque =
      ForceRotationTorque{}.torque(air, moving(Vec3::Zero(), 0.5 * rate), spinning(rate, radius));
  const Vec3 turn = -0.75 * rate;
  const Vec3 stokes = pi * air.viscosity * d * d * d * turn;
  EXPECT_NEAR((torque - stokes).norm() / stokes.norm(), 0.0, 1e-14);
}

// Dennis, Singh and Ingham (1980), R with the radius; Sawatzki (1970) as in Alobaid (2013).
TEST(rotation_torque, has_the_published_coefficients) {
  const auto coefficient = [](double re) {
    return ForceRotationTorque::coefficient_by_re(re) / re;
  };
  EXPECT_NEAR(coefficient(1.0), 16.0 * pi, 1e-12);
  EXPECT_NEAR(coefficient(20.0), 3.0473, 1e-4);
  EXPECT_NEAR(coefficient(100.0), 0.966, 1e-12);
  EXPECT_NEAR(coefficient(2e4), 6.8 / std::sqrt(2e4), 1e-12);
  EXPECT_NEAR(coefficient(1e5), 0.058 / std::pow(1e5, 0.05), 1e-12);
  EXPECT_NEAR(coefficient(1e6), 0.397 / std::pow(1e6, 0.2), 1e-12);
}

TEST(rotation_torque, grows_continuously_with_the_rate) {
  double before = ForceRotationTorque::coefficient_by_re(1e-3) * 1e-3;
  for (double re = 1.001e-3; re < 1e7; re *= 1.001) {
    const double torque = ForceRotationTorque::coefficient_by_re(re) * re;
    // It goes at most with the square of the rate.
    EXPECT_GT(torque, before) << "R " << re;
    EXPECT_LT(torque, 1.0021 * before) << "R " << re;
    before = torque;
  }
}

TEST(lorentz, is_that_of_its_fields) {
  ForceLorentz lorentz = example<ForceLorentz>();
  GrainState grain = some_grain();
  grain.velocity.setZero();
  EXPECT_EQ(lorentz.force(air, {}, grain), 1e-9 * lorentz.electric);
  // Along x through a field along y a positive charge is driven along z.
  lorentz.electric.setZero();
  lorentz.magnetic = Vec3(0.0, 2.0, 0.0);
  grain.velocity = Vec3(3.0, 0.0, 0.0);
  EXPECT_NEAR(lorentz.force(air, {}, grain).z(), 6e-9, 1e-24);
}

TEST(lorentz, takes_its_parameters_by_name_and_without_them_does_nothing) {
  ForceLorentz lorentz;
  EXPECT_EQ(lorentz.force(air, {}, some_grain()), Vec3::Zero());
  double next = 1.0;
  for (std::size_t n = 0; n < ForceLorentz::parameters.size(); ++n)
    for (int d = 0; d < ForceLorentz::parameters[n].values; ++d) lorentz.values(n)[d] = next++;
  EXPECT_EQ(lorentz.charge, 1.0);
  EXPECT_EQ(lorentz.electric, Vec3(2.0, 3.0, 4.0));
  EXPECT_EQ(lorentz.magnetic, Vec3(5.0, 6.0, 7.0));
}

}  // namespace
}  // namespace gasgrain
