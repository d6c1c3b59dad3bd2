// The lid-driven cavity against U. Ghia, K. N. Ghia and C. T. Shin, J. Comput. Phys. 48 (1982) 387,
// tables I and II, in a plane of the grid one cell deep.
#include <gtest/gtest.h>

#include "tests/gas_cases.h"

namespace gasgrain {
namespace {

using namespace gas_cases;

struct Point {
  double place;
  std::array<double, 3> velocity;  // at Re = 100, 400, 1000
};

// Velocity along the lid on the vertical line through the middle.
constexpr Point vertical[] = {
    {0.9766, {0.84123, 0.75837, 0.65928}},    {0.9688, {0.78871, 0.68439, 0.57492}},
    {0.9609, {0.73722, 0.61756, 0.51117}},    {0.9531, {0.68717, 0.55892, 0.46604}},
    {0.8516, {0.23151, 0.29093, 0.33304}},    {0.7344, {0.00332, 0.16256, 0.18719}},
    {0.6172, {-0.13641, 0.02135, 0.05702}},   {0.5000, {-0.20581, -0.11477, -0.06080}},
    {0.4531, {-0.21090, -0.17119, -0.10648}}, {0.2813, {-0.15662, -0.32726, -0.27805}},
    {0.1719, {-0.10150, -0.24299, -0.38289}}, {0.1016, {-0.06434, -0.14612, -0.29730}},
    {0.0703, {-0.04775, -0.10338, -0.22220}}, {0.0625, {-0.04192, -0.09266, -0.20196}},
    {0.0547, {-0.03717, -0.08186, -0.18109}}};

// Velocity across it on the horizontal line through the middle. The value at 0.9063 and Re = 400 is
// left out: the table's -0.23827 breaks the smooth run of its neighbours.
constexpr double left_out = 1e9;
constexpr Point horizontal[] = {
    {0.9688, {-0.05906, -0.12146, -0.21388}}, {0.9609, {-0.07391, -0.15663, -0.27669}},
    {0.9531, {-0.08864, -0.19254, -0.33714}}, {0.9453, {-0.10313, -0.22847, -0.39188}},
    {0.9063, {-0.16914, left_out, -0.51550}}, {0.8594, {-0.22445, -0.44993, -0.42665}},
    {0.8047, {-0.24533, -0.38598, -0.31966}}, {0.5000, {0.05454, 0.05186, 0.02526}},
    {0.2344, {0.17527, 0.30174, 0.32235}},    {0.2266, {0.17507, 0.30203, 0.33075}},
    {0.1563, {0.16077, 0.28124, 0.37095}},    {0.0938, {0.12317, 0.22965, 0.32627}},
    {0.0781, {0.10890, 0.20920, 0.30353}},    {0.0703, {0.10091, 0.19713, 0.29012}},
    {0.0625, {0.09233, 0.18360, 0.27485}}};

constexpr int cells = 64;

// The two velocities on the lines through the middle.
struct Lines {
  std::vector<double> u;
  std::vector<double> w;
};

Lines lines_of(const GasSolver& gas) {
  Lines lines;
  for (int n = 0; n < cells; ++n) {
    lines.u.push_back(gas.state().velocity[0](cells / 2, 0, n));
    lines.w.push_back(gas.state().velocity[2](n, 0, cells / 2));
  }
  return lines;
}

Lines steady_cavity(double reynolds, Convection convection) {
  Sides sides = walls;
  sides[2] = sides[3] = &wall_free_slip;
  GasInput input = box({cells, 1, cells}, Vec3(1, 1.0 / cells, 1), sides);
  input.gravity = Vec3::Zero();
  input.density = 1;
  input.viscosity = 1 / reynolds;
  input.wall_velocity[5] = Vec3(1, 0, 0);
  input.convection = convection;
  input.courant_max = 1000;
  input.step = 1;
  GasSolver gas(input, self());
  // Until nothing changes any more: 1e-4 of the lid's velocity in a unit of time.
  for (int n = 0; n < 300; ++n) {
    const Array3<double> before = gas.state().velocity[0];
    for (int m = 0; m < 10; ++m) gas.advance(0.05);
    double change = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      change = std::max(change, std::abs(gas.state().velocity[0][i] - before[i]));
    if (change < 0.5e-4) return lines_of(gas);
  }
  ADD_FAILURE() << "not steady";
  return lines_of(gas);
}

// Linear between the values of a line that begins at `first` and has the walls' at its ends.
double at(const std::vector<double>& line, double place) {
  const double s = place * cells - 0.5;
  const int n = static_cast<int>(std::floor(s));
  return (1 - (s - n)) * line.at(n) + (s - n) * line.at(n + 1);
}

void expect_ghia(int column, double reynolds, Convection convection) {
  const auto [u, w] = steady_cavity(reynolds, convection);
  double worst = 0;
  for (const Point& point : vertical)
    worst = std::max(worst, std::abs(at(u, point.place) - point.velocity[column]));
  for (const Point& point : horizontal)
    if (point.velocity[column] != left_out)
      worst = std::max(worst, std::abs(at(w, point.place) - point.velocity[column]));
  std::printf("Re %g: greatest deviation %.4f of the lid's velocity\n", reynolds, worst);
  EXPECT_LT(worst, 0.02);
}

TEST(gas_cavity, agrees_with_ghia_at_reynolds_100) {
  expect_ghia(0, 100, Convection::tvd);
}

TEST(gas_cavity, agrees_with_ghia_at_reynolds_400) {
  expect_ghia(1, 400, Convection::tvd);
}

TEST(gas_cavity, agrees_with_ghia_at_reynolds_1000) {
  expect_ghia(2, 1000, Convection::tvd);
}

}  // namespace
}  // namespace gasgrain
