// Every estimate of effect_sizes/ against the law that it stands for, evaluated at the same scales.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "coupling/exchange/drag/models.h"
#include "coupling/exchange/drag/polydisperse.h"
#include "coupling/exchange/effect_sizes/sizes.h"
#include "tests/exchange_lists.h"

namespace gasgrain {
namespace {

constexpr GasProperties air{1.2, 1.8e-5};

// Glass in air over four decades of slip, shear and spin.
std::vector<Scales> many_scales() {
  std::vector<Scales> list;
  for (const double d : {1e-4, 2.5e-3})
    for (const double slip : {0.05, 1.0, 40.0})
      for (const double vorticity : {10.0, 3e3})
        for (const double spin : {0.0, 500.0}) {
          Scales at;
          at.diameter = d;
          at.solid_density = 2500.0;
          at.gravity = 9.81;
          at.gas_density = air.density;
          at.viscosity = air.viscosity;
          at.void_fraction = 0.6;
          at.slip = slip;
          at.drag = DragTang::coefficient(air, at.void_fraction, slip, d) * slip;
          at.vorticity = vorticity;
          at.spin = spin;
          at.gas_acceleration = 300.0 * slip;
          at.grain_acceleration = 20.0;
          at.pressure_gradient = 7e3;
          at.viscous_force = 12.0;
          at.charge = 1e-10;
          at.electric = 2e4;
          at.magnetic = 0.3;
          at.speed = 2.0;
          list.push_back(at);
        }
  return list;
}

// The state in which a force is as large as its scales allow: what is taken as opposed or across
// is.
GasAtParticle gas_of(const Scales& at) {
  GasAtParticle gas;
  gas.velocity = Vec3(at.slip, 0.0, 0.0);
  gas.vorticity = Vec3(0.0, 0.0, at.vorticity);
  gas.acceleration = Vec3(at.gas_acceleration, 0.0, 0.0);
  gas.pressure_gradient = Vec3(0.0, at.pressure_gradient, 0.0);
  gas.viscous_force = Vec3(0.0, 0.0, at.viscous_force);
  return gas;
}

GrainState grain_of(const Scales& at) {
  GrainState grain;
  grain.angular_velocity = Vec3(0.0, 0.0, -at.spin);
  grain.radius = at.radius();
  return grain;
}

// The law's own answer [N]; a torque over the radius.
template <class Chosen>
double by_law(const Scales& at) {
  const GasAtParticle gas = gas_of(at);
  const GrainState grain = grain_of(at);
  if constexpr (Chosen::kind == ForceKind::steady)
    return Chosen::force(air, gas, at.radius()).norm();
  else if constexpr (Chosen::kind == ForceKind::motion)
    return Chosen{}.force(air, gas, grain).norm();
  else if constexpr (Chosen::kind == ForceKind::torque)
    return Chosen{}.torque(air, gas, grain).norm() / at.radius();
  else if constexpr (Chosen::kind == ForceKind::added_mass)
    return Chosen::added_mass(air, at.radius()) * at.relative_acceleration();
  else {
    // The acceleration held for the estimate's own duration.
    constexpr int steps = 200;
    const double dt = SizeOf<Chosen>::duration(at) / steps;
    const typename Chosen::Memory memory(dt, 2.0 * steps * dt, 0.01);
    const Vec3 rate(at.relative_acceleration(), 0.0, 0.0);
    std::vector<double> state(memory.state_size(), 0.0);
    for (int n = 1; n < steps; ++n) memory.advance(state.data(), rate);
    return memory.added_mass(air, at.radius()) * rate[0] +
           memory.history(air, at.radius(), state.data())[0];
  }
}
// Its charge and fields are the scene's.
template <>
double by_law<ForceLorentz>(const Scales& at) {
  ForceLorentz lorentz;
  lorentz.charge = at.charge;
  lorentz.electric = Vec3(0.0, at.electric, 0.0);
  lorentz.magnetic = Vec3(0.0, 0.0, -at.magnetic);
  GrainState grain = grain_of(at);
  grain.velocity = Vec3(at.speed, 0.0, 0.0);
  return lorentz.force(air, gas_of(at), grain).norm();
}

// How far an estimate may be off: round-off where it is the law at these scales, else what its
// header states.
template <class Chosen>
constexpr double stated_factor = 1.0 + 1e-12;
template <>
constexpr double stated_factor<ForceSaffmanMei> = 1.7;
template <>
constexpr double stated_factor<ForceRotationTorque> = 1.35;
// The mean over a step against the value at its end: 1 / (4 steps); and the memory's tolerance.
template <>
constexpr double stated_factor<ForceBasset> = 1.012;

template <class Chosen>
class EffectSizeOf : public testing::Test {};
TYPED_TEST_SUITE(EffectSizeOf, ListedTypes<Force>::type, ListedName);

TYPED_TEST(EffectSizeOf, agrees_with_the_force_within_its_stated_factor) {
  for (const Scales& at : many_scales()) {
    const double law = by_law<TypeParam>(at);
    const double size = SizeOf<TypeParam>::force(at);
    ASSERT_GT(law, 0.0);
    EXPECT_LE(size, stated_factor<TypeParam> * law) << "d " << at.diameter << ", U " << at.slip;
    EXPECT_GE(size * stated_factor<TypeParam>, law) << "d " << at.diameter << ", U " << at.slip;
  }
}

TYPED_TEST(EffectSizeOf, bears_the_word_of_its_force) {
  EXPECT_EQ(SizeOf<TypeParam>::name, TypeParam::name);
}

TEST(EffectSizes, each_has_a_name_of_its_own_a_number_and_a_threshold) {
  std::set<std::string> names;
  for_each_size([&](auto size) {
    EXPECT_TRUE(names.insert(std::string(size.name)).second) << size.name;
    EXPECT_FALSE(size.number_name.empty()) << size.name;
    EXPECT_FALSE(size.threshold.empty()) << size.name;
  });
  EXPECT_EQ(names.size(), 1 + std::variant_size_v<Force> + std::variant_size_v<SizesBesideForces> +
                              std::variant_size_v<SizesOfAbsent>);
}

// Where nothing is known there is neither a size nor a division by zero.
TEST(EffectSizes, of_no_scales_is_nothing) {
  for_each_size([](auto size) {
    EXPECT_EQ(size.force(Scales{}), 0.0) << size.name;
    EXPECT_EQ(size.number(Scales{}), 0.0) << size.name;
  });
}

TEST(EffectSizes, are_finite_and_not_negative_wherever_gas_and_grain_are) {
  for (const Scales& at : many_scales())
    for_each_size([&](auto size) {
      EXPECT_TRUE(std::isfinite(size.force(at)) && size.force(at) >= 0.0) << size.name;
    });
}

// In creeping flow, where K goes as d, the estimate is the correction itself.
TEST(EffectSizes, polydisperse_is_the_correction_of_a_law_in_creeping_flow) {
  Scales at = many_scales().front();
  at.slip = 1e-6;
  at.void_fraction = 1.0;
  at.smallest_diameter = 0.8 * at.diameter;
  at.sauter_diameter = 0.9 * at.diameter;
  const double alone = DragSchillerNaumann::coefficient(air, 1.0, at.slip, at.diameter);
  const double mixed = polydisperse_coefficient<DragSchillerNaumann>(air, 1.0, at.slip, at.diameter,
                                                                     at.sauter_diameter);
  at.drag = alone * at.slip;
  // Re = 7e-6: 0.15 Re^0.687 is 4e-5.
  EXPECT_NEAR(SizePolydisperse::force(at), (mixed - alone) * at.slip, 1e-4 * at.drag);
}

TEST(EffectSizes, self_disturbance_is_the_growth_of_drag_that_the_exchange_applies) {
  Scales at = many_scales().front();
  at.void_fraction = 1.0;
  at.drag = DragTang::coefficient(air, 1.0, at.slip, at.diameter) * at.slip;
  // A bell of equal variances s^2, the grid's share of which is nothing.
  at.bell = 2.0 * at.diameter;
  Footprint bell;
  bell.variance = Vec3::Constant(at.bell * at.bell);
  bell.h = Vec3::Constant(1e-9);
  const double K = at.drag / at.slip;
  const double share = K * disturbance_per_force(air, bell, Vec3(at.slip, 0.0, 0.0));
  ASSERT_LT(share, greatest_share);
  EXPECT_NEAR(SizeSelfDisturbance::force(at), at.drag * share / (1.0 - share), 1e-9 * at.drag);
  at.void_fraction = 0.5;
  EXPECT_LT(SizeSelfDisturbance::force(at), 1e-3 * at.drag);
}

// Of Hoomans et al.; a grid of one diameter is 14 % deeper.
TEST(EffectSizes, depth_correction_vanishes_at_the_depth_of_a_plane_of_spheres) {
  Scales at = many_scales().front();
  at.depth = 2.0 / std::pow(3.0, 0.75) * at.diameter;
  EXPECT_NEAR(SizeDepthCorrection::force(at), 0.0, 1e-12 * at.drag);
  at.depth = at.diameter;
  EXPECT_NEAR(SizeDepthCorrection::force(at), 0.14 * at.drag, 0.001 * at.drag);
}

TEST(EffectSizes, van_der_waals_passes_the_weight_between_fine_and_coarse_powders) {
  Scales at = many_scales().front();
  at.diameter = 30e-6;  // Geldart's C: sticks
  EXPECT_GT(SizeVanDerWaals::number(at), 1.0);
  at.diameter = 500e-6;  // B: does not
  EXPECT_LT(SizeVanDerWaals::number(at), needed_share);
}

}  // namespace
}  // namespace gasgrain
