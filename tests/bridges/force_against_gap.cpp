// Every law's force at four gaps, three volumes, three angles, for equal grains, unequal grains and
// walls, against its published formula written another way or, for the toroid, integrated.
#include <gtest/gtest.h>

#include <functional>

#include "tests/bridges/bridge_cases.h"

namespace gasgrain::bridge::test {
namespace {

// Same formula, other arithmetic: round-off, with some digits lost where a published form cancels.
constexpr double same_formula = 1e-8;

template <class Law>
void expect_force(const std::function<double(const LiquidBridge&, double)>& reference,
                  double tolerance) {
  int compared = 0;
  for_each_bridge([&](const LiquidBridge& b) {
    for (const double share : gap_shares) {
      const double gap = share * Law::rupture_distance(b);
      const double expected = reference(b, gap);
      EXPECT_GT(expected, 0.0);
      EXPECT_NEAR(capillary_force<Law>(b, gap) / expected, 1.0, tolerance)
          << Law::name << " V " << b.volume << " theta " << b.contact_angle << " gap " << gap
          << " wall " << b.on_wall;
      ++compared;
    }
  });
  EXPECT_EQ(compared, 3 * 3 * 3 * 4);
}

TEST(ForceAgainstGap, mikami_as_powers_of_the_volume) {
  expect_force<BridgeMikami>(
      [](const LiquidBridge& b, double gap) {
        const double t2 = b.contact_angle * b.contact_angle;
        if (b.on_wall) {
          const double r = 0.5 * b.radius, v = b.volume / std::pow(r, 3);
          return pi * r * b.surface_tension *
                 (std::pow(v, -0.016 * t2 - 0.012) * std::exp(1.2 - 0.76 * t2) *
                      std::exp(-1.9 * gap / r / std::pow(v, 0.51)) +
                  std::log(std::pow(v, 0.013) * std::exp(0.18)));
        }
        const double r = b.radius, v = b.volume / std::pow(r, 3);
        return pi * r * b.surface_tension *
               (std::pow(v, -0.034 * t2 - 0.019) * std::exp(0.48 - 0.96 * t2) *
                    std::exp(-1.1 * gap / r / std::pow(v, 0.53)) +
                std::log(std::pow(v, 0.0042) * std::exp(0.078)));
      },
      same_formula);
}

// With the whole gap s: 2.1 S = 1.05 s (R / V)^(1/2), 10 S^2 = 2.5 s^2 R / V.
TEST(ForceAgainstGap, willett_with_the_whole_gap) {
  expect_force<BridgeWillett>(
      [](const LiquidBridge& b, double s) {
        return 2.0 * pi * b.radius * b.surface_tension * std::cos(b.contact_angle) /
               (1.0 + 1.05 * s * std::sqrt(b.radius / b.volume) +
                2.5 * s * s * b.radius / b.volume);
      },
      same_formula);
}

// The appendix as a table: rows f1 to f4, columns powers of ln v, of each 1, theta, theta^2.
double willett_table(int row, double log_v, double theta) {
  static constexpr double table[4][4][3] = {{{-0.44507, 0.050832, -1.1466},
                                             {-0.1119, -0.000411, -0.1490},
                                             {-0.012101, -0.0036456, -0.01255},
                                             {-0.0005, -0.0003505, -0.00029076}},
                                            {{1.9222, -0.57473, -1.2918},
                                             {-0.0668, -0.1201, -0.22574},
                                             {-0.0013375, -0.0068988, -0.01137},
                                             {0.0, 0.0, 0.0}},
                                            {{1.268, -0.01396, -0.23566},
                                             {0.198, 0.092, -0.06418},
                                             {0.02232, 0.02238, -0.009853},
                                             {0.0008585, 0.001318, -0.00053}},
                                            {{-0.010703, 0.073776, -0.34742},
                                             {0.03345, 0.04543, -0.09056},
                                             {0.0018574, 0.004456, -0.006257},
                                             {0.0, 0.0, 0.0}}};
  double sum = 0.0;
  for (int power = 0; power < 4; ++power)
    for (int of_angle = 0; of_angle < 3; ++of_angle)
      sum += table[row][power][of_angle] * std::pow(log_v, power) * std::pow(theta, of_angle);
  return sum;
}

TEST(ForceAgainstGap, willett_fit_as_a_table_and_the_closed_form_of_small_volumes) {
  expect_force<BridgeWillettFit>(
      [](const LiquidBridge& b, double gap) {
        const double v = b.volume / std::pow(b.radius, 3), theta = b.contact_angle;
        if (v < 1e-4) return BridgeWillett::force(b, gap);
        const auto f = [&](int row) { return willett_table(row - 1, std::log(v), theta); };
        const double s = gap / 2.0 / std::sqrt(b.volume / b.radius);
        const double fall =
            s == 0.0 ? 0.0 : f(2) * std::pow(s, f(3)) * std::pow(s, f(4) * std::log(s));
        return 2.0 * pi * b.radius * b.surface_tension * std::exp(f(1)) / std::exp(fall);
      },
      same_formula);
}

double energy_form(const LiquidBridge& b, double s) {
  if (s == 0.0) return 2.0 * pi * b.radius * b.surface_tension * std::cos(b.contact_angle);
  const double root = std::sqrt(1.0 + 2.0 * b.volume / (pi * b.radius * s * s));
  return 2.0 * pi * b.radius * b.surface_tension * std::cos(b.contact_angle) * (1.0 - 1.0 / root);
}

TEST(ForceAgainstGap, rabinovich_energy_as_one_minus_a_root) {
  expect_force<BridgeRabinovichEnergy>(energy_form, same_formula);
}

// W = -2 gamma cos theta A, A = 2 pi R d the wetted surface of one grain, d from V = pi R (s d +
// d^2), twice its parabolic half; F = dW/ds by central differences.
TEST(ForceAgainstGap, rabinovich_energy_is_the_slope_of_the_surface_energy) {
  const auto energy = [](const LiquidBridge& b, double s) {
    const double q = 2.0 * b.volume / (pi * b.radius);
    const double d = 0.5 * (std::sqrt(s * s + q) - s);  // pi R (2 d s + 2 d^2) = V
    return -2.0 * b.surface_tension * std::cos(b.contact_angle) * 2.0 * pi * b.radius * d;
  };
  expect_force<BridgeRabinovichEnergy>(
      [&](const LiquidBridge& b, double s) {
        const double h = 1e-5 * std::cbrt(b.volume);
        return (energy(b, s + h) - energy(b, s - h)) / (2.0 * h);
      },
      1e-6);  // error of the difference (h / s)^2, and round-off / h
}

TEST(ForceAgainstGap, rabinovich_with_the_filling_angle_as_published) {
  expect_force<BridgeRabinovich>(
      [](const LiquidBridge& b, double s) {
        const double a2 =
            s == 0.0
                ? std::sqrt(2.0 * b.volume / (pi * std::pow(b.radius, 3)))
                : s / b.radius * (std::sqrt(1.0 + 2.0 * b.volume / (pi * b.radius * s * s)) - 1.0);
        return energy_form(b, s) + 2.0 * pi * b.radius * b.surface_tension *
                                       std::sin(std::sqrt(a2)) *
                                       std::sin(b.contact_angle + std::sqrt(a2));
      },
      same_formula);
}

// The toroid from its definition: contact circle and angle give the circle of the meridian, its
// liquid by Simpson's rule over the angle along the arc.
struct DrawnToroid {
  double r1, r2, volume;
};
DrawnToroid draw(const LiquidBridge& b, double gap, double beta) {
  const double x_c = 0.5 * gap + b.radius * (1.0 - std::cos(beta));
  const double y_c = b.radius * std::sin(beta);
  const double alpha = beta + b.contact_angle;
  const double r1 = x_c / std::cos(alpha);  // the arc's normal at the contact circle
  const double centre = y_c + r1 * std::sin(alpha);
  const int n = 400;
  const double end = 0.5 * pi - alpha;  // angle of the arc from the neck
  double sum = 0.0;
  for (int k = 0; k <= n; ++k) {
    const double t = end * k / n, y = centre - r1 * std::cos(t);
    sum += (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * y * y * r1 * std::cos(t);
  }
  const double half = pi * sum * end / (3.0 * n);
  double cap = 0.0;  // solid of the grain within x_c, by Simpson's rule, exact for its parabola
  const double top = b.radius * (1.0 - std::cos(beta));
  for (const auto& [x, weight] : {std::pair{0.0, 1.0}, {0.5 * top, 4.0}, {top, 1.0}})
    cap += weight * pi * (2.0 * b.radius * x - x * x) * top / 6.0;
  return {r1, centre - r1, 2.0 * (half - cap)};
}

TEST(ForceAgainstGap, lian_toroid_as_tension_and_suction_at_the_neck_of_a_drawn_toroid) {
  expect_force<BridgeLianToroid>(
      [](const LiquidBridge& b, double gap) {
        double low = 1e-6, high = 0.5 * pi - b.contact_angle - 1e-3;
        for (int n = 0; n < 100; ++n) {
          const double middle = 0.5 * (low + high);
          const DrawnToroid drawn = draw(b, gap, middle);
          (drawn.r2 > 0.0 && drawn.volume > b.volume ? high : low) = middle;
        }
        const DrawnToroid drawn = draw(b, gap, low);
        const double suction = b.surface_tension * (1.0 / drawn.r1 - 1.0 / drawn.r2);
        return 2.0 * pi * drawn.r2 * b.surface_tension + pi * drawn.r2 * drawn.r2 * suction;
      },
      1e-6);  // Simpson's rule
}

TEST(ForceAgainstGap, the_toroid_that_is_found_holds_the_liquid) {
  for (const double v : {1e-15, 1e-9, 1e-4, 0.1})
    for (int angle = 0; angle <= 90; angle += 10)
      for (const LiquidBridge& b :
           {equal_grains(v, angle * degree), grain_on_wall(v, angle * degree)})
        for (const double share : {0.0, 1e-3, 0.3, 0.8}) {
          const double gap = share * lian_rupture_distance(b);
          const double beta = toroid_filling_angle(b, gap);
          // Digits that the volume loses where bridge and caps nearly cancel.
          EXPECT_NEAR(toroid_volume(b.radius, gap, b.contact_angle, beta) / b.volume, 1.0, 1e-9)
              << "v " << v << " angle " << angle << " at " << share;
        }
}

// Around beta + theta = 90 degrees the meridian passes a straight line, and the integrals of its
// bulge pass from a closed form to a series and back.
TEST(ForceAgainstGap, the_toroids_bulge_is_its_quadrature_where_the_meridian_is_nearly_straight) {
  for (const double t : {-0.3, -0.051, -0.049, -1e-3, 1e-3, 0.02, 0.049, 0.051, 0.3}) {
    double first = 0.0, second = 0.0;
    const int n = 200;
    for (int k = 0; k <= n; ++k) {
      const double u = static_cast<double>(k) / n;
      const double g = t * u * u / (1.0 + std::sqrt(1.0 - t * t * u * u));
      const double weight = (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) / (3.0 * n);
      first += weight * g;
      second += weight * g * g;
    }
    const Bulge bulge = toroid_bulge(std::acos(t));
    // Simpson's rule 1e-9; the closed form loses nine digits of the second at t = 0.05.
    EXPECT_NEAR(bulge.first / first, 1.0, 1e-9) << t;
    EXPECT_NEAR(bulge.second / second, 1.0, 5e-9) << t;
  }
}

}  // namespace
}  // namespace gasgrain::bridge::test
