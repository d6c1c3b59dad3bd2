#include "gas_solver/operators/runaway.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas_solver/gas_fault.h"

namespace gasgrain {
namespace {

struct FastestFace {
  double rate = 0;  // [1/s]
  double velocity = 0;
  int axis = 0;
  Int3 cell{0, 0, 0};
};

FastestFace fastest_of_own(const Domain& domain, const CellVector& velocity) {
  FastestFace fastest;
  for (int d = 0; d < 3; ++d) {
    const double h = domain.grid().spacing()[d];
    for_each_cell(domain.faces(d), [&](int i, int j, int k) {
      const double u = velocity[d](i, j, k);
      if (std::abs(u) / h > fastest.rate) fastest = {std::abs(u) / h, u, d, {i, j, k}};
    });
  }
  return fastest;
}

// The same on all ranks.
FastestFace fastest_of_all(const Domain& domain, const CellVector& velocity) {
  FastestFace fastest = fastest_of_own(domain, velocity);
  const Communicator& comm = domain.comm();
  const double greatest = comm.max(fastest.rate);
  constexpr double none = std::numeric_limits<int>::max();
  const double teller = comm.min(fastest.rate == greatest ? comm.rank() : none);
  MPI_Bcast(&fastest, sizeof(fastest), MPI_BYTE, static_cast<int>(teller), comm.handle());
  return fastest;
}

}  // namespace

double courant_rate(const Domain& domain, const CellVector& velocity) {
  double rate = 0;
  for (int d = 0; d < 3; ++d) {
    const Array3<double>& u = velocity[d];
    double greatest = 0;
    for_each_cell(domain.faces(d), [&](int i, int j, int k) {
      greatest = std::max(greatest, std::abs(u(i, j, k)));
    });
    rate = std::max(rate, greatest / domain.grid().spacing()[d]);
  }
  return domain.comm().max(rate);
}

void require_bounded(const Domain& domain, const GasInput& input, const CellVector& velocity,
                     const CourantRates& rates, double interval, double time) {
  const double whole = std::min(input.step, interval);
  const double rate = std::max(rates.flow, rates.inflow);
  if (!(whole * rate > input.courant_max * input.substeps_max)) return;
  std::string where = "through an [[inflow]]";
  if (rates.flow >= rates.inflow) {
    const FastestFace face = fastest_of_all(domain, velocity);
    const BoxGrid& grid = domain.grid();
    Vec3 x;
    for (int d = 0; d < 3; ++d)
      x[d] = grid.lo[d] + grid.spacing()[d] * (face.cell[d] + (d == face.axis ? 0.0 : 0.5));
    where = fmt::format(
        "in cell ({}, {}, {}) at x = {:.6g}, y = {:.6g}, z = {:.6g} m, along {} with {:.4g} m/s",
        face.cell[0], face.cell[1], face.cell[2], x[0], x[1], x[2], "xyz"[face.axis],
        face.velocity);
  }
  throw GasFault(fmt::format(
      "the Courant number of the gas has run away at t = {:.9g} s: {} it crosses {:.3g} cells in a "
      "step of {:g} s, more than [time] courant_max x substeps_max = {:g} x {}. Likely an "
      "[[inflow]] is too fast or comes too suddenly (velocity, ramp), or grains and gas are "
      "coupled "
      "too seldom ('every N'). If the flow is meant to be so fast, lower [time] step.",
      time, where, whole * rate, whole, input.courant_max, input.substeps_max));
}

}  // namespace gasgrain
