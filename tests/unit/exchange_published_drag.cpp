// Drag laws against points worked out from the equations as their sources print them, in other
// variables than the code uses. Air of 1.2 kg/m3 and 1.8e-5 Pa s, spheres of 1.2 mm; K over 3 pi mu
// d.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupling/exchange/drag/models.h"
#include "coupling/exchange/drag/polydisperse.h"

namespace gasgrain {
namespace {

constexpr GasProperties air{1.2, 1.8e-5};
constexpr double d = 1.2e-3;

double slip_of(double re, double eps) {
  return re * air.viscosity / (eps * air.density * d);
}

template <class Law>
double over_stokes(double eps, double re) {
  return Law::coefficient(air, eps, slip_of(re, eps), d) / (3.0 * pi * air.viscosity * d);
}

// Hoomans et al. (2001), eqs 27-30: beta V_p / (1 - eps). The points have ten digits.
TEST(drag_ergun_wen_yu, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.4, 10.0), 14.93055556, 1e-8);
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.45, 100.0), 31.79012346, 1e-8);
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.7, 300.0), 45.23809524, 1e-8);
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.9, 100.0), 6.013977333, 1e-8);
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.95, 10.0), 1.981439592, 1e-8);
  EXPECT_NEAR(over_stokes<DragErgunWenYu>(0.8, 2000.0), 66.23430215, 1e-7);
}

// In a uniform fixed bed model A reads eps dp/L = n K u; the drop must be Ergun's.
TEST(drag_ergun_wen_yu, reproduces_erguns_pressure_drop_of_a_fixed_bed) {
  for (const double eps : {0.36, 0.4, 0.5, 0.6})
    for (const double u : {0.01, 0.3, 4.0}) {
      const double n = (1.0 - eps) / (pi / 6.0 * d * d * d);
      const double drop = n * DragErgunWenYu::coefficient(air, eps, u, d) * u / eps;
      const double U = eps * u;
      const double ergun =
          150.0 * air.viscosity * (1.0 - eps) * (1.0 - eps) * U / (eps * eps * eps * d * d) +
          1.75 * air.density * (1.0 - eps) * U * U / (eps * eps * eps * d);
      EXPECT_NEAR(drop / ergun, 1.0, 1e-13) << "eps " << eps << ", u " << u;
    }
}

TEST(drag_ergun_wen_yu, jumps_at_its_switch_as_published) {
  const auto jump = [](double re) {
    return over_stokes<DragErgunWenYu>(std::nextafter(0.8, 0.0), re) /
           over_stokes<DragErgunWenYu>(0.8, re);
  };
  EXPECT_NEAR(jump(0.0), 1.153, 1e-3);
  EXPECT_NEAR(jump(100.0), 1.733, 1e-3);
}

// The thesis's form beta = mu / d^2 (A phi^2 / eps + B phi Re) with B = 0.6057 eps^2 + ...; its
// coefficients are rounded, 0.2088 being 9 times 0.0232.
TEST(drag_koch_hill, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragKochHill>(0.8, 100.0), 9.114301516, 1e-8);
  EXPECT_NEAR(over_stokes<DragKochHill>(0.6, 50.0), 10.72075185, 1e-7);
  EXPECT_NEAR(over_stokes<DragKochHill>(0.4, 100.0), 34.681, 1e-7);
}

TEST(drag_koch_hill, is_carmans_law_for_a_packed_bed_in_creeping_flow) {
  const double eps = 0.4;
  const double u = 1e-12;
  const double n = (1.0 - eps) / (pi / 6.0 * d * d * d);
  const double drop = n * DragKochHill::coefficient(air, eps, u, d) * u / eps;
  const double carman =
      180.0 * air.viscosity * (1.0 - eps) * (1.0 - eps) * (eps * u) / (eps * eps * eps * d * d);
  EXPECT_NEAR(drop / carman, 1.0, 1e-9);
}

TEST(drag_koch_hill, steps_by_one_percent_where_its_branches_meet) {
  const double dense = DragKochHill::f0(0.6);
  const double dilute = DragKochHill::f0(std::nextafter(0.6, 1.0));
  EXPECT_NEAR(dense, 10.0 * 0.4 / 0.216, 1e-12);
  EXPECT_NEAR(dense / dilute, 1.0104, 1e-4);
}

// F_d = C_d (pi d^2 / 4) (rho U^2 / 2) eps^-beta with U = eps u, over u.
TEST(drag_di_felice, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragDiFelice>(0.4, 100.0), 36.02510066, 1e-7);
  EXPECT_NEAR(over_stokes<DragDiFelice>(0.7, 10.0), 4.103874985, 1e-8);
  EXPECT_NEAR(over_stokes<DragDiFelice>(0.9, 500.0), 19.10624659, 1e-7);
}

// K u = eps V_p (rho_p - rho) g, so that U / U_isolated = eps^2 K(1) / K(eps).
TEST(drag_di_felice, settles_as_richardson_and_zaki_found_in_creeping_flow) {
  for (const double eps : {0.5, 0.7, 0.9})
    EXPECT_NEAR(
        eps * eps * over_stokes<DragDiFelice>(1.0, 0.0) / over_stokes<DragDiFelice>(eps, 0.0),
        std::pow(eps, 4.7), 1e-12);
}

// The switch, C_d and exponent of Gidaspow's book are those of Hoomans et al. (2001).
TEST(drag_gidaspow, is_ergun_wen_yu_under_another_name) {
  for (const double eps : {0.3, 0.79, 0.81, 1.0})
    for (const double re : {0.0, 10.0, 2000.0})
      EXPECT_EQ(over_stokes<DragGidaspow>(eps, re), over_stokes<DragErgunWenYu>(eps, re));
}

// Huilin and Gidaspow (2003), the weight as a function of phi.
TEST(drag_gidaspow_blend, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragGidaspowBlend>(0.6, 100.0), 21.73411604, 1e-8);
  EXPECT_NEAR(over_stokes<DragGidaspowBlend>(0.78, 50.0), 8.439273162, 1e-8);
  EXPECT_NEAR(over_stokes<DragGidaspowBlend>(0.9, 100.0), 6.083237391, 1e-8);
}

TEST(drag_gidaspow_blend, is_the_mean_of_both_laws_at_the_switch) {
  const double u = slip_of(300.0, 0.8);
  EXPECT_NEAR(DragGidaspowBlend::coefficient(air, 0.8, u, d) /
                  (DragErgunWenYu::ergun(air, 0.8, u, d) + DragErgunWenYu::wen_yu(air, 0.8, u, d)),
              0.5, 1e-14);
}

// Benyahia et al. (2006), a point in every regime; Re of the diameter, eps^2 F.
TEST(drag_hill_koch_ladd, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.995, 0.5), 1.082839844, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.995, 40.0), 1.986767233, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.95, 1.0), 1.829677052, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.8, 2.0), 3.56039672, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.8, 100.0), 9.567491362, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.55, 2.0), 8.243623903, 1e-8);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(0.4, 100.0), 34.681, 1e-7);
}

TEST(drag_hill_koch_ladd, starts_gently_and_then_is_the_linear_law) {
  const double eps = 0.6;
  // To first order in Re a random array knows no inertia, and F1 R^2 says how it begins.
  const double at_rest = over_stokes<DragHillKochLadd>(eps, 0.0);
  EXPECT_NEAR(over_stokes<DragHillKochLadd>(eps, 2e-3) / at_rest, 1.0, 1e-7);
  EXPECT_LT(over_stokes<DragHillKochLadd>(eps, 5.0), over_stokes<DragKochHill>(eps, 5.0));
  for (const double re : {6.0, 50.0, 200.0})
    EXPECT_NEAR(over_stokes<DragHillKochLadd>(eps, re) / over_stokes<DragKochHill>(eps, re), 1.0,
                1e-13);
}

TEST(drag_hill_koch_ladd, steps_where_its_solid_fractions_meet_as_published) {
  const auto step = [](double eps, double re) {
    return over_stokes<DragHillKochLadd>(eps - 1e-9, re) /
           over_stokes<DragHillKochLadd>(eps + 1e-9, re);
  };
  EXPECT_NEAR(step(0.99, 0.0), 1.2788, 1e-4);
  EXPECT_NEAR(step(0.99, 10.0), 1.0, 1e-6);
  EXPECT_NEAR(step(0.9, 3.0), 1.0 - 1.25e-4, 1e-6);
  EXPECT_NEAR(step(0.6, 3.0), 1.0, 1e-6);
}

// Beetstra et al. (2007), eps F.
TEST(drag_beetstra, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragBeetstra>(0.4, 100.0), 35.91576615, 1e-7);
  EXPECT_NEAR(over_stokes<DragBeetstra>(0.6, 10.0), 8.078554945, 1e-8);
  EXPECT_NEAR(over_stokes<DragBeetstra>(0.9, 300.0), 16.39648552, 1e-7);
}

// Tenneti et al. (2011), eps^2 F.
TEST(drag_tenneti, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragTenneti>(0.5, 100.0), 20.3535391, 1e-7);
  EXPECT_NEAR(over_stokes<DragTenneti>(0.7, 10.0), 5.746775537, 1e-8);
  EXPECT_NEAR(over_stokes<DragTenneti>(0.9, 300.0), 10.65022817, 1e-7);
}

// Tang et al. (2015), eps F.
TEST(drag_tang, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragTang>(0.5, 100.0), 22.22156397, 1e-7);
  EXPECT_NEAR(over_stokes<DragTang>(0.6, 500.0), 36.30828981, 1e-7);
  EXPECT_NEAR(over_stokes<DragTang>(0.9, 50.0), 5.361053136, 1e-8);
}

TEST(drag_tang, has_a_constant_drag_coefficient_beyond_its_range) {
  for (const double eps : {0.4, 0.7, 1.0})
    EXPECT_NEAR(DragTang::inertial(eps, 4000.0) / DragTang::inertial(eps, 1000.0), 4.0, 1e-13);
}

TEST(drag_schiller_naumann, has_the_values_of_its_source) {
  EXPECT_NEAR(over_stokes<DragSchillerNaumann>(1.0, 1.0), 1.15, 1e-12);
  EXPECT_NEAR(over_stokes<DragSchillerNaumann>(1.0, 10.0), 1.729610809, 1e-8);
  EXPECT_NEAR(over_stokes<DragSchillerNaumann>(1.0, 100.0), 4.548879546, 1e-8);
  EXPECT_NEAR(over_stokes<DragSchillerNaumann>(1.0, 2000.0), 0.44 * 2000.0 / 24.0, 1e-8);
}

// Clift and Gauvin (1971), within 6 % of measured spheres up to Re = 3e5.
TEST(drag_schiller_naumann, follows_the_standard_drag_curve) {
  for (double re = 0.01; re < 2e5; re *= 1.3) {
    const double cd = 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687)) +
                      0.42 / (1.0 + 42500.0 * std::pow(re, -1.16));
    EXPECT_NEAR(DragSchillerNaumann::over_stokes(re) * 24.0 / re / cd, 1.0,
                re < 800.0 ? 0.06 : 0.15)
        << "Re " << re;
  }
}

// Two sizes in one bed, solid shares 0.3 and 0.7. Total force and drag of model A must be one
// another's complement, and the pressure drop that of a bed of Sauter's mean diameter.
TEST(drag_polydisperse, splits_the_total_force_into_drag_and_pressure_gradient) {
  const double eps = 0.55;
  const double phi = 1.0 - eps;
  const std::array<double, 2> share{0.3, 0.7};
  const std::array<double, 2> diameter{1e-3, 2.5e-3};
  const double sauter = 1.0 / (share[0] / diameter[0] + share[1] / diameter[1]);
  const double u = 0.7;
  const double volume = pi / 6.0 * sauter * sauter * sauter;
  const double drop = phi / volume * DragBeetstra::coefficient(air, eps, u, sauter) * u / eps;
  double sum_of_total = 0.0;
  for (int i = 0; i < 2; ++i) {
    const double y = diameter[i] / sauter;
    const double K = polydisperse_coefficient<DragBeetstra>(air, eps, u, diameter[i], sauter);
    const double own_volume = pi / 6.0 * std::pow(diameter[i], 3);
    const double total = K * u + own_volume * drop;
    sum_of_total += share[i] * phi / own_volume * total;
    // In units of the bed of one size, without the fitted third term.
    const double of_one_size = DragBeetstra::coefficient(air, eps, u, sauter) * u / eps * y;
    const double third = 0.064 * eps * y * y * y;
    EXPECT_NEAR(total / of_one_size, polydisperse_total_factor(y, eps) - third, 1e-12);
  }
  EXPECT_NEAR(sum_of_total / drop, 1.0, 1e-12);
}

TEST(drag_polydisperse, leaves_a_bed_of_one_size_alone) {
  EXPECT_EQ(polydisperse_coefficient<DragBeetstra>(air, 0.5, 0.3, d, d),
            DragBeetstra::coefficient(air, 0.5, 0.3, d));
}

}  // namespace
}  // namespace gasgrain
