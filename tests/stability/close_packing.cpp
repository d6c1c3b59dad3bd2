// Beds as dense as spheres can be: solid shares of 0.64 and 0.74, and 0.85 by force.
//
// Gas is blown through the bed. Bounds, whatever the method and the cells: the gas's void fraction
// stays within [1 - solids_limit, 1]; no solids are lost, and what was moved is counted; a grain's
// drag is no more than the law's at the densest that it takes; what the gas lost the grains have. A
// bed that cannot be is refused. The naive way, void fractions handed to the gas as they are, runs
// away.
#include <gtest/gtest.h>

#include <limits>

#include "gas_solver/packing_limit.h"
#include "tests/exchange_lists.h"
#include "tests/stability/coupled_bed.h"

namespace gasgrain::stability {
namespace {

constexpr double diameter = 1e-3;
constexpr int side = 6;        // of the box, and height of the bed or so, in diameters
constexpr double wind = 0.05;  // superficial [m/s]

// Face-centred cubic, 4 grains a cube, pulled apart or pushed into each other to a solid share; as
// much as fits is moved at random. It stands on the floor, endless sideways.
Cloud packed(double solids, double width) {
  const int cubes = std::max(1L, std::lround(width / diameter / std::cbrt(4 * pi / 6 / solids)));
  const double cube = width / cubes;
  const double d = std::cbrt(solids * std::pow(cube, 3) / 4 * 6 / pi);
  const double room = std::max(0.0, 0.49 * (cube / std::sqrt(2.0) - d));
  Random random(5);
  Cloud cloud;
  const std::array<Vec3, 4> corners{Vec3(0.25, 0.25, 0.25), Vec3(0.75, 0.75, 0.25),
                                    Vec3(0.75, 0.25, 0.75), Vec3(0.25, 0.75, 0.75)};
  for (int i = 0; i < cubes; ++i)
    for (int j = 0; j < cubes; ++j)
      for (int k = 0; k < cubes; ++k)
        for (const Vec3& corner : corners)
          cloud.add(cube * (Vec3(i, j, k) + corner) + random.vector(room / std::sqrt(3.0)),
                    Vec3::Zero(), 0.5 * d, 2500.0 * sphere_volume(0.5 * d));
  return cloud;
}

// The bed fills the lower half.
GasInput column(double cell) {
  const int n = static_cast<int>(std::lround(side / cell));
  GasInput input =
      gas_cases::box({n, n, 2 * n}, Vec3(side, side, 2 * side) * diameter, all_periodic);
  input.sides[4] = &wall_no_slip;
  input.sides[5] = &outlet;
  input.inflows = {gas_cases::whole_side(input, 4, wind)};
  input.tolerance = 1e-8;
  return input;
}

GasProperties properties_of(const GasInput& input) {
  return {input.density, input.viscosity};
}

double solids_in(const GasSolver& gas) {
  double sum = 0.0;
  for (const double eps : gas.void_fraction()) sum += (1.0 - eps) * gas.grid().cell_volume();
  return sum;
}

// Of history.csv's columns.
double column_of(const Ledger& ledger, const std::string& name) {
  const std::vector<std::string> names = ledger.column_names();
  const auto at = std::find(names.begin(), names.end(), name);
  EXPECT_NE(at, names.end()) << name;
  return ledger.column_values()[at - names.begin()];
}

void expect_bounded(double solids, double cell, const std::string& method) {
  SCOPED_TRACE(method + ", solids " + std::to_string(solids) + ", cells of " +
               std::to_string(cell) + " d");
  const GasInput input = column(cell);
  const Cloud cloud = packed(solids, side * diameter);
  Pace pace;
  pace.interval = 1e-3;
  pace.steps = 10;
  CoupledBed bed(input, "drag koch_hill pressure_gradient void_fraction " + method, pace, cloud);
  bed.weight = Vec3(0.0, 0.0, -9.81);
  double volume = 0.0;
  for (const double r : cloud.radius) volume += sphere_volume(r);
  double slip = wind;
  for (int n = 0; n < 5; ++n) {
    bed.advance();
    const double least = least_void_fraction(bed.gas());
    EXPECT_GE(least, 1.0 - solids_limit - 1e-9);
    // At the limit there are cells that were above it.
    EXPECT_EQ(bed.report().moved_cells > 0, least < 1.0 - solids_limit + 1e-9);
    EXPECT_NEAR(solids_in(bed.gas()) / volume, 1.0, 1e-12);
    EXPECT_LT(bed.report().continuity_residual, 1e-7);
    EXPECT_LT(bed.report().mass_imbalance, 1e-12);
    // K is of the slip before this coupling. A grain that fills its cells is taken for one alone.
    const double law = DragKochHill::coefficient(properties_of(input), least_drag_void_fraction,
                                                 slip, 2.0 * cloud.radius[0]);
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      EXPECT_LE(bed.records().K(p), law / (1.0 - greatest_share));
    slip = std::max(slip, gas_cases::greatest_speed(bed.gas()) + bed.fastest_grain());
  }
  // Without the gas they would all have fallen freely.
  EXPECT_LT(bed.fastest_grain(), 5e-3 * 9.81 * 1.001);
  const Ledger ledger = bed.ledger();
  EXPECT_LT(ledger.residual(), 1e-12);
  EXPECT_NEAR(bed.grain_momentum()[2],
              ledger.taken()[2] + column_of(ledger, "impulse_free_z_Ns") +
                  column_of(ledger, "impulse_host_z_Ns"),
              1e-12 * std::abs(bed.grain_momentum()[2]));
}

TEST(close_packing, is_bounded_and_balanced_for_every_method_and_size_of_cells) {
  for (const double solids : {0.64, 0.74})
    for (const double cell : {0.5, 1.0, 2.0})
      for_each_choice<VoidFractionMethod>(
          [&](auto method) { expect_bounded(solids, cell, std::string(method.name)); });
}

TEST(close_packing, beyond_what_can_be_is_refused_in_words) {
  GasInput input = column(1.0);
  input.grid.hi[2] *= 0.5;
  input.grid.cells[2] /= 2;
  CoupledBed bed(input, "drag koch_hill void_fraction exact", {}, packed(0.85, side * diameter));
  try {
    bed.advance();
    FAIL() << "a box full of 0.85 of solids was accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("the particles do not fit"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("stiffness"), std::string::npos) << e.what();
  }
}

struct Unlimited {
  double least_eps = 1.0;
  double speed = 0.0;  // of the gas, greatest [m/s]
};

// The same bed held still, with the void fractions and the law as they come.
Unlimited unlimited(double solids, double cell) {
  const GasInput input = column(cell);
  const Cloud cloud = packed(solids, side * diameter);
  GasSolver gas(input, self());
  ParticleWeights weights;
  weights.find(cloud.view(), VoidFractionExact{},
               whole_frame(gas.grid(), VoidFractionExact{}, cloud.radius[0]));
  Array3<double> deposited(weights.tile());
  deposit_solid_volume(cloud.view(), weights, deposited);
  const Array3<double> volume = wrapped(deposited, gas.grid());
  Array3<double> eps(gas.own());
  Array3<double> drag(gas.own());
  const double slip = 2.0 * wind;  // between the grains
  Unlimited met;
  for (std::size_t n = 0; n < eps.size(); ++n) {
    eps[n] = 1.0 - volume[n] / gas.grid().cell_volume();
    met.least_eps = std::min(met.least_eps, eps[n]);
    drag[n] = (1.0 - eps[n]) / sphere_volume(cloud.radius[0]) *
              DragKochHill::coefficient(properties_of(input), eps[n], slip, 2.0 * cloud.radius[0]);
  }
  gas.set_void_fraction(eps);
  const Array3<double> none(gas.own());
  gas.set_drag(drag, {none, none, none});
  try {
    for (int n = 0; n < 10 && met.speed < 1e9; ++n) {
      gas.advance(1e-3);
      met.speed = gas_cases::greatest_speed(gas);
    }
  } catch (const Error&) {  // the gas will not go on with such a flow
    met.speed = std::numeric_limits<double>::infinity();
  }
  return met;
}

TEST(close_packing, without_the_limit_runs_away) {
  // Negative where two grains and more meet in a cell.
  EXPECT_LT(unlimited(0.74, 0.5).least_eps, -0.1);
  const Unlimited met = unlimited(0.85, 0.5);
  std::printf("solids not limited: eps from %.3g, gas at %.3g m/s in a wind of %g m/s\n",
              met.least_eps, met.speed, wind);
  EXPECT_GT(met.speed, 1e6 * wind);
}

}  // namespace
}  // namespace gasgrain::stability
