// A grain in a steady stream is moved slowly sideways, across a cell face that is a periodic side:
// how much its drag and the cells' void fraction change from one coupling to the next.
#pragma once

#include "tests/stability/coupled_bed.h"

namespace gasgrain::stability {

// A stream along x at Reynolds number `reynolds` of the grain, endless sideways, through a box of
// cells of one size.
struct Stream {
  static constexpr double diameter = 1e-3;  // of the grain [m]
  static constexpr double speed = 0.1;      // [m/s]
  GasInput input;
  Pace pace;

  // `cell`: over the diameter. `side`: of the box in cells.
  Stream(double cell, int side, double reynolds)
      : input(gas_cases::box({side, side, side}, Vec3::Constant(side * cell * diameter),
                             all_periodic)) {
    input.sides[0] = &wall_no_slip;
    input.sides[1] = &outlet;
    input.inflows = {gas_cases::whole_side(input, 0, speed)};
    input.gravity = Vec3::Zero();
    input.viscosity = input.density * speed * diameter / reynolds;
    input.tolerance = 1e-8;
    input.courant_max = 1e300;  // a step is a coupling interval
    // Four times through the box.
    pace.interval = input.step = 4.0 * input.grid.hi[0] / speed;
  }
  // A grain that nothing moves, `cells` away from the middle.
  [[nodiscard]] Cloud grain(const Vec3& cells) const {
    Cloud cloud;
    Vec3 x = input.grid.spacing();
    for (int d = 0; d < 3; ++d) x[d] *= input.grid.cells[d] / 2 + cells[d];
    cloud.add(x, Vec3::Zero(), 0.5 * diameter, 1.0);
    return cloud;
  }
};

struct Crossing {
  double force_jump = 0.0;  // greatest change of the drag from one coupling to the next / its mean
  double force_spread = 0.0;  // greatest less least, over the mean
  double eps_jump = 0.0;      // greatest change of a cell's void fraction
  double eps_least = 1.0;
  double eps_most = 0.0;
  double ledger_residual = 0.0;
};

// 0.02 cells a coupling, from 0.6 cells before the side to 0.6 behind it.
inline Crossing cross_a_face(double cell, int side, const std::string& effects) {
  constexpr double cells_a_coupling = 0.02;
  constexpr int couplings = 60;
  constexpr int settling = 5;  // of the stream
  constexpr double sideways = 0.01 * Stream::speed;
  Stream scene(cell, side, 20.0);
  const double h = scene.input.grid.spacing()[1];
  scene.pace.interval = scene.input.step = cells_a_coupling * h / sideways;
  Cloud cloud = scene.grain(Vec3(0.3, 0.3, 0.3));
  cloud.position[1] = scene.input.grid.hi[1] - 0.6 * h;
  CoupledBed bed(scene.input, effects, scene.pace, cloud);
  bed.held = true;
  for (int n = 0; n < settling; ++n) bed.advance();
  bed.cloud.velocity[1] = sideways;

  Crossing met;
  double least = 1e300;
  double most = 0.0;
  double sum = 0.0;
  double before = 0.0;
  Array3<double> eps_before = bed.gas().void_fraction();
  for (int n = 0; n < couplings; ++n) {
    bed.advance();
    const double force = bed.forces()[0];
    const Array3<double> eps = bed.gas().void_fraction();
    if (n > 0) met.force_jump = std::max(met.force_jump, std::abs(force - before));
    for (std::size_t c = 0; c < eps.size(); ++c) {
      met.eps_jump = std::max(met.eps_jump, std::abs(eps[c] - eps_before[c]));
      met.eps_least = std::min(met.eps_least, eps[c]);
      met.eps_most = std::max(met.eps_most, eps[c]);
    }
    eps_before = eps;
    before = force;
    sum += force;
    least = std::min(least, force);
    most = std::max(most, force);
  }
  met.force_jump /= sum / couplings;
  met.force_spread = (most - least) / (sum / couplings);
  met.ledger_residual = bed.ledger().residual();
  return met;
}

}  // namespace gasgrain::stability
