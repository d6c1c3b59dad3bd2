// What holds for every drag law of the LIST.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <vector>

#include "tests/exchange_cloud.h"
#include "tests/exchange_lists.h"

namespace gasgrain {
namespace {

template <class Law>
class drag : public testing::Test {
 protected:
  static double K(double eps, double slip) { return Law::coefficient(air, eps, slip, diameter); }
  static double slip_of(double re, double eps) {
    return re * air.viscosity / (eps * air.density * diameter);
  }

  static constexpr GasProperties air{1.2, 1.8e-5};
  static constexpr double diameter = 1.2e-3;
};
TYPED_TEST_SUITE(drag, ListedTypes<DragModel>::type, ListedName);

template <class Law>
constexpr bool for_one_sphere = Law::range.eps_min > 0.98;

// Drag of model A over Stokes' drag at the superficial slip.
template <class Law>
double over_stokes(double eps, double re) {
  const GasProperties gas{1.0, 1.0};
  const double slip = re / eps;
  return Law::coefficient(gas, eps, slip, 1.0) / (eps * stokes_coefficient(gas, 1.0));
}

// K that refresh_drag() finds for one particle in a uniform gas.
double refreshed(const DragModel& law, double eps, const Vec3& u, const Vec3& v) {
  const BoxGrid grid = uneven_box({false, false, false});
  const TileFrame frame{grid, grid.all()};
  Cloud cloud;
  cloud.add(0.5 * (grid.lo + grid.hi), v, cloud_radius);
  ParticleWeights weights;
  weights.find(cloud.view(), VoidFractionOffset{}, frame);
  Effects effects;
  effects.drag = law;
  effects.ignore_self_disturbance = true;  // of the law alone
  FieldStore fields(effects.lent(), frame.tile);
  for (int d = 0; d < 3; ++d) fields.vector(GasField::velocity)[d].fill(u[d]);
  fields.scalar(GasField::void_fraction).fill(eps);
  ExchangeRecords records;
  records.resize(1);
  refresh_drag(cloud.view(), weights, effects, {1.2, 1.8e-5}, fields, records);
  return records.K(0);
}

TYPED_TEST(drag, reduces_to_stokes_for_an_isolated_sphere) {
  const double stokes = 3.0 * pi * this->air.viscosity * this->diameter;
  EXPECT_NEAR(this->K(1.0, 0.0) / stokes, TypeParam::stokes_limit, 1e-12);
  // Re = 1e-6: the first correction of every law goes at least with Re^(1/2).
  EXPECT_NEAR(this->K(1.0, this->slip_of(1e-6, 1.0)) / stokes, TypeParam::stokes_limit, 1e-3);
  // Dallavalle's sphere has 0.96, Gidaspow's blend 0.994.
  EXPECT_NEAR(TypeParam::stokes_limit, 1.0, 0.041);
}

TYPED_TEST(drag, is_positive_and_finite_for_every_void_fraction_and_slip) {
  for (double eps = least_drag_void_fraction; eps <= 1.0; eps += 0.01)
    for (const double slip : {0.0, 1e-300, 1e-12, 1e-3, 0.1, 1.0, 10.0, 100.0}) {
      const double k = this->K(eps, slip);
      EXPECT_TRUE(std::isfinite(k) && k > 0.0) << "eps " << eps << ", slip " << slip;
    }
}

TYPED_TEST(drag, is_finite_within_its_declared_range_which_is_not_empty) {
  const DragRange range = TypeParam::range;
  ASSERT_LT(range.eps_min, range.eps_max);
  ASSERT_LT(range.re_min, range.re_max);
  for (const double eps : {range.eps_min, range.eps_max})
    for (const double re : {range.re_min, range.re_max}) {
      const double k = this->K(eps, this->slip_of(re, eps));
      EXPECT_TRUE(std::isfinite(k) && k > 0.0) << "eps " << eps << ", Re " << re;
    }
}

// The force, not K: Di Felice's K falls a little around Re = 1 in a dense bed.
TYPED_TEST(drag, force_grows_with_the_slip) {
  for (const double eps : {0.2, 0.36, 0.45, 0.6, 0.79, 0.81, 0.95, 1.0}) {
    double before = 0.0;
    for (double re = 1e-4; re < 1e5; re *= 1.05) {
      const double slip = this->slip_of(re, eps);
      const double force = this->K(eps, slip) * slip;
      EXPECT_GT(force, before) << "eps " << eps << ", Re " << re;
      before = force;
    }
  }
}

TYPED_TEST(drag, grows_as_the_bed_gets_denser) {
  for (const double slip : {0.0, 0.1, 1.0, 10.0}) {
    if (for_one_sphere<TypeParam>) {
      EXPECT_EQ(this->K(least_drag_void_fraction, slip), this->K(1.0, slip));
      continue;
    }
    // Below phi = 0.01 Hill, Koch and Ladd keep the total force of the isolated sphere, so that K
    // falls as eps^2: theirs is looked at from the most dilute bed of the source.
    const bool full_hill_koch_ladd = std::is_same_v<TypeParam, DragHillKochLadd>;
    const double most_dilute = full_hill_koch_ladd ? TypeParam::range.eps_max : 1.0;
    double before = 0.0;
    for (double eps = most_dilute; eps >= least_drag_void_fraction; eps -= 1e-3) {
      EXPECT_GT(this->K(eps, slip), before) << "eps " << eps << ", slip " << slip;
      before = this->K(eps, slip);
    }
  }
}

TYPED_TEST(drag, is_continuous_in_the_void_fraction_except_at_its_stated_switches) {
  const double step = 1e-9;
  // Next to eps = 1 Tenneti's law grows with phi^(1/3): 5e-4 for this step.
  const double allowed = 1e-3;
  for (const double slip : {0.0, 0.5, 5.0})
    for (double eps = least_drag_void_fraction; eps < 1.0; eps += 1e-3) {
      const double next = eps + step;
      bool across = false;
      for (const double place : TypeParam::eps_switches)
        across = across || (eps <= place + step && next >= place - step);
      if (!across) {
        EXPECT_NEAR(this->K(next, slip) / this->K(eps, slip), 1.0, allowed) << "eps " << eps;
      }
    }
  EXPECT_NEAR(this->K(1.0 - step, 0.0) / this->K(1.0, 0.0), 1.0, allowed);
}

TYPED_TEST(drag, is_continuous_in_the_slip) {
  // C_d of Wen and Yu changes its form at Re = 1000 with a step of 0.4 %.
  for (const double eps : {0.45, 0.7, 0.9})
    for (double re = 1e-3; re < 1e4; re *= 1.0001)
      ASSERT_NEAR(
          this->K(eps, this->slip_of(1.0001 * re, eps)) / this->K(eps, this->slip_of(re, eps)), 1.0,
          5e-3)
          << "Re " << re;
}

TYPED_TEST(drag, depends_on_the_slip_alone) {
  const Vec3 u(0.3, -0.2, 1.4);
  const Vec3 v(-0.1, 0.5, 0.2);
  const Vec3 boost(3.0, -7.0, 11.0);
  for (const double eps : {0.45, 0.7, 0.9}) {
    const double k = refreshed(TypeParam{}, eps, u, v);
    EXPECT_NEAR(refreshed(TypeParam{}, eps, u + boost, v + boost) / k, 1.0, 1e-13);
    EXPECT_NEAR(k / this->K(eps, (u - v).norm()), 1.0, 1e-13);
  }
}

TYPED_TEST(drag, does_not_change_under_rotation) {
  const Vec3 u(0.3, -0.2, 1.4);
  const Vec3 v(-0.1, 0.5, 0.2);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (const double eps : {0.45, 0.7, 0.9})
    EXPECT_NEAR(refreshed(TypeParam{}, eps, turn * u, turn * v) / refreshed(TypeParam{}, eps, u, v),
                1.0, 1e-13);
}

TYPED_TEST(drag, takes_cells_too_dense_for_any_law_as_the_densest_bed) {
  // The weights sum to 1 to round-off only.
  EXPECT_NEAR(refreshed(TypeParam{}, -0.3, Vec3::UnitZ(), Vec3::Zero()) /
                  refreshed(TypeParam{}, least_drag_void_fraction, Vec3::UnitZ(), Vec3::Zero()),
              1.0, 1e-13);
}

// phi = 0.4, where every law for beds has data. Resolved simulations differ by 6 % in creeping flow
// and by 20 % at Re = 100 (Beetstra's being the greatest); Ergun's packed columns and Di Felice's
// fluidized beds lie up to 40 % beside their mean. An error of one eps or of the radius for the
// diameter is 40 to 100 %.
TEST(drag_laws, agree_in_a_dense_bed_within_their_published_scatter) {
  const double eps = 0.6;
  for (const double re : {0.0, 10.0, 100.0}) {
    const std::vector<double> resolved{
        over_stokes<DragKochHill>(eps, re), over_stokes<DragHillKochLadd>(eps, re),
        over_stokes<DragBeetstra>(eps, re), over_stokes<DragTenneti>(eps, re),
        over_stokes<DragTang>(eps, re)};
    const double mean = std::accumulate(resolved.begin(), resolved.end(), 0.0) / resolved.size();
    for (const double f : resolved)
      EXPECT_NEAR(f / mean, 1.0, re == 0.0 ? 0.06 : 0.2) << "Re " << re;
    for_each_choice<DragModel>([&](auto law) {
      using Law = decltype(law);
      if (for_one_sphere<Law> || re == 0.0) return;
      EXPECT_NEAR(over_stokes<Law>(eps, re) / mean, 1.0, 0.4) << law.name << ", Re " << re;
    });
  }
}

// Three sources share the sphere of Schiller and Naumann, the others keep their own. Koch and
// Hill's laws have no data for it: 2.8 of Stokes' drag at Re = 100 instead of 4.5.
TEST(drag_laws, end_in_the_drag_of_one_sphere) {
  for (const double re : {0.1, 1.0, 10.0, 100.0}) {
    const double sphere = over_stokes<DragSchillerNaumann>(1.0, re);
    EXPECT_NEAR(over_stokes<DragErgunWenYu>(1.0, re) / sphere, 1.0, 1e-12) << "Re " << re;
    EXPECT_NEAR(over_stokes<DragTenneti>(1.0, re) / sphere, 1.0, 1e-12) << "Re " << re;
    EXPECT_NEAR(over_stokes<DragGidaspowBlend>(1.0, re) / sphere, 1.0, 0.01) << "Re " << re;
    EXPECT_NEAR(over_stokes<DragDiFelice>(1.0, re) / sphere, 1.0, 0.2) << "Re " << re;
    EXPECT_NEAR(over_stokes<DragTang>(1.0, re) / sphere, 1.0, 0.2) << "Re " << re;
    EXPECT_NEAR(over_stokes<DragBeetstra>(1.0, re) / sphere, 1.0, 0.2) << "Re " << re;
  }
}

}  // namespace
}  // namespace gasgrain
