#include "gas_solver/momentum/predictor.h"

#include <algorithm>
#include <cmath>

#include "gas_solver/boundary/unknown_faces.h"

namespace gasgrain {
namespace {

// Holds the unknown faces of every component.
IndexBox with_high_faces(IndexBox box) {
  for (int& hi : box.hi) ++hi;
  return box;
}

constexpr int max_sweeps = 100;

// What further sweeps would change, when their changes go on as a geometric series; with a margin,
// as the slowest of several series is the last to show.
double change_to_come(double change, double before) {
  constexpr double margin = 3.0;
  const double ratio = before > 0 ? change / before : 1.0;
  return ratio < 1 ? margin * change * ratio / (1 - ratio) : change;
}

// Outer iterations repeat the explicit parts by themselves.
int default_passes(TimeScheme scheme, PressureVelocity method) {
  return scheme == TimeScheme::crank_nicolson && method == PressureVelocity::projection ? 3 : 1;
}

}  // namespace

Predictor::Predictor(const Domain& domain, const GasInput& input, Halo& halo)
    : domain_(domain),
      walls_(input.walls()),
      tolerance_(input.tolerance),
      theta_(time_weight(input.scheme)),
      passes_(input.correction_passes > 0 ? input.correction_passes
                                          : default_passes(input.scheme, input.pressure_velocity)),
      halo_(halo),
      assembly_(domain, input),
      finish_(domain, input),
      rows_(with_high_faces(domain.own())) {}

MomentumReport Predictor::predict(GasState& state, const MomentumStep& step) {
  MomentumReport report;
  solution_ = state.velocity;
  for (int n = 0; n < passes_; ++n) {
    const bool at_hand = n == 0 && theta_ == 1.0;
    pass(state, step, at_hand ? state.velocity : mean_in_time(step.before, solution_), report);
  }
  std::swap(state.velocity, solution_);
  finish_.share_mobility(halo_);
  return report;
}

void Predictor::pass(GasState& state, const MomentumStep& step, const CellVector& lagged,
                     MomentumReport& report) {
  double scale = 0;  // squares of the velocity, components done
  for (int d = 0; d < 3; ++d) {
    assembly_.assemble(state, d, lagged, step.inflow, step.turbulence, rows_);
    finish_.finish(state, d, step, assembly_.face_void_fraction(), rows_);
    bool converged = false;
    double change_before = 0;
    for (int n = 0; n < max_sweeps && !converged; ++n) {
      sweep(d, true);
      halo_.exchange({&solution_[d]});
      Change last = sweep(d, false);
      halo_.exchange({&solution_[d]});
      std::vector<double> sums{last.change, last.squares};
      domain_.comm().sum_in_place(sums);
      const double change = std::sqrt(sums[0]);
      const double left = std::min(change, change_to_come(change, change_before));
      change_before = change;
      converged = left <= tolerance_ * std::sqrt(scale + sums[1]);
      if (converged) scale += sums[1];
    }
    if (!converged) ++report.not_converged;
  }
  for (int d = 0; d < 3; ++d) fill_ghost_velocities(domain_, walls_, d, solution_[d]);
}

const CellVector& Predictor::mean_in_time(const CellVector& before, const CellVector& after) {
  if (lagged_[0].size() == 0) lagged_ = make_vector(domain_.box());
  for (int d = 0; d < 3; ++d)
    for (std::size_t n = 0; n < before[d].size(); ++n)
      lagged_[d][n] = (1 - theta_) * before[d][n] + theta_ * after[d][n];
  return lagged_;
}

Predictor::Change Predictor::sweep(int component, bool forth) {
  Array3<double>& u = solution_[component];
  const IndexBox faces = unknown_faces(domain_, walls_.sides, component);
  const std::ptrdiff_t sy = u.stride(1);
  const std::ptrdiff_t sz = u.stride(2);
  const int nx = faces.extent(0);
  Change sums;
  const auto update = [&](const MomentumRow& row, std::ptrdiff_t o) {
    const auto& c = row.coefficient;
    const double others =
        row.source + c[2] * u[o - sy] + c[3] * u[o + sy] + c[4] * u[o - sz] + c[5] * u[o + sz];
    const double value = (others + c[0] * u[o - 1] + c[1] * u[o + 1]) * row.inverse_diagonal;
    const double change = value - u[o];
    u[o] = value;
    sums.change += change * change;
    sums.squares += value * value;
  };
  const int rows_y = faces.extent(1);
  const int lines = rows_y * faces.extent(2);
  for (int n = 0; n < lines; ++n) {
    const int line = forth ? n : lines - 1 - n;
    const int j = faces.lo[1] + line % rows_y;
    const int k = faces.lo[2] + line / rows_y;
    const std::ptrdiff_t first = u.offset(faces.lo[0], j, k);
    const MomentumRow* const row = &rows_(faces.lo[0], j, k);
    if (forth)
      for (int i = 0; i < nx; ++i) update(row[i], first + i);
    else
      for (int i = nx - 1; i >= 0; --i) update(row[i], first + i);
  }
  return sums;
}

}  // namespace gasgrain
