// A cloud of grains in a gas, in a periodic box: they have nothing but each other. a = T / tau, T
// the coupling interval, tau = m / K; L: mass of the grains over that of the gas.
#pragma once

#include "tests/stability/explicit_drag.h"

namespace gasgrain::stability {

struct Stiffness {
  double interval_over_relaxation = 1.0;  // a
  double loading = 1.0;                   // L
};

struct PeriodicCloud {
  static constexpr const char* effects = "drag koch_hill void_fraction trilinear";
  static constexpr double radius = 0.25e-3;
  static constexpr int grains_along = 4;

  GasInput input = gas_cases::box({grains_along, grains_along, grains_along}, Vec3::Constant(4e-3),
                                  all_periodic);
  Cloud cloud;
  Pace pace;
  double mean_speed = 0.0;  // of the grains at first [m/s]
  double common = 0.0;      // mean velocity at last [m/s]

  // `scatter`: of the grains' first velocities, relative. `cells`: crossed in an interval.
  // `fastest`: that they may be [m/s]; as it is they creep.
  PeriodicCloud(const Stiffness& stiffness, double scatter, double cells = 1e-2,
                double fastest = 1e-3) {
    input.gravity = Vec3::Zero();
    input.tolerance = 1e-12;
    input.step = 1e9;  // the coupling interval
    input.courant_max = 1e300;
    input.viscosity = 1e-3;
    const double volume = input.grid.hi.prod();
    const double solids = std::pow(grains_along, 3) * sphere_volume(radius) / volume;
    const double density = stiffness.loading * input.density * (1 - solids) / solids;
    cloud = lattice(input.grid, grains_along, radius, density, Vec3::Zero());
    CoupledBed once(input, effects, pace, cloud);
    once.advance();
    pace.interval = stiffness.interval_over_relaxation * cloud.mass[0] / once.records().K(0);
    pace.steps = 4;
    mean_speed = std::min(fastest, cells * input.grid.spacing()[0] / pace.interval);
    Random random(3);
    for (std::size_t n = 0; n < cloud.velocity.size(); ++n)
      cloud.velocity[n] =
          mean_speed * ((n % 3 == 0 ? 1.0 : 0.0) + scatter * random.between(-1.0, 1.0));
    common = mean_speed * stiffness.loading / (1.0 + stiffness.loading);
  }
};

}  // namespace gasgrain::stability
