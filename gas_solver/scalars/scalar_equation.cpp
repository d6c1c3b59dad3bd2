#include "gas_solver/scalars/scalar_equation.h"

#include <algorithm>
#include <cmath>

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/operators/convection/tvd.h"

namespace gasgrain {
namespace {

constexpr int max_sweeps = 200;

}  // namespace

ScalarEquation::ScalarEquation(const Domain& domain, Halo& halo, const ScalarChoices& choices)
    : domain_(domain),
      halo_(halo),
      choices_(choices),
      spacing_(domain.grid().spacing()),
      rows_(domain.box()),
      addition_(choices.limited ? domain.box() : IndexBox{}),
      gain_(choices.limited ? domain.box() : IndexBox{}) {
  // A cell that is its own neighbour round a periodic axis exchanges nothing.
  for (int d = 0; d < 3; ++d)
    if (!domain.grid().periodic[d] || domain.grid().cells[d] > 1) axes_.push_back(d);
}

void ScalarEquation::assemble(const ScalarTerms& terms,
                              const std::array<Array3<double>, 3>& mass_flux, double step,
                              const Array3<double>& before, const ScalarBoundary& boundary) {
  if (choices_.limited) limited_gain(mass_flux, before);
  const Array3<double>& gamma = terms.conductance;
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = rows_.offset(i, j, k);
    ScalarRow& row = rows_[o];
    row.coefficient.fill(0.0);
    const double inertia = terms.mass[o] / step;
    double diagonal = inertia + terms.sink[o];
    row.source = inertia * before[o] + terms.source[o];
    for (const int d : axes_) {
      const std::ptrdiff_t s = gamma.stride(d);
      const double per_h = 1.0 / spacing_[d];
      const double conduct = 0.5 * per_h * per_h;
      const double lo =
          std::max(mass_flux[d][o], 0.0) * per_h + conduct * (gamma[o - s] + gamma[o]);
      const double hi =
          std::max(-mass_flux[d][o + s], 0.0) * per_h + conduct * (gamma[o] + gamma[o + s]);
      row.coefficient[side_of(d, false)] = lo;
      row.coefficient[side_of(d, true)] = hi;
      diagonal += lo + hi;
    }
    if (choices_.limited) {
      if (choices_.positive && gain_[o] < 0 && before[o] > 0)
        diagonal -= gain_[o] / before[o];
      else
        row.source += gain_[o];
    }
    row.inverse_diagonal = diagonal;
  });
  close_sides(terms, mass_flux, boundary);
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    double& diagonal = rows_(i, j, k).inverse_diagonal;
    diagonal = 1.0 / diagonal;
  });
}

// The same as in momentum/assembly.cpp, with fluxes that lie on the sides already.
void ScalarEquation::limited_gain(const std::array<Array3<double>, 3>& mass_flux,
                                  const Array3<double>& phi) {
  gain_.fill(0.0);
  for (const int d : axes_) {
    const Array3<double>& flux = mass_flux[d];
    const std::ptrdiff_t s = phi.stride(d);
    const double per_h = 1.0 / spacing_[d];
    IndexBox lows = domain_.own();
    ++lows.hi[d];  // the high sides of the last
    for_each_cell(lows, [&](int i, int j, int k) {
      const auto o = phi.offset(i, j, k);
      const double f = flux[o] * per_h;
      addition_[o] =
          std::max(f, 0.0) * ConvectionTvd().addition(phi[o - 2 * s], phi[o - s], phi[o]) +
          std::min(f, 0.0) * ConvectionTvd().addition(phi[o + s], phi[o], phi[o - s]);
    });
    for_each_cell(domain_.own(), [&](int i, int j, int k) {
      const auto o = phi.offset(i, j, k);
      gain_[o] += addition_[o] - addition_[o + s];
    });
  }
}

// What enters through a side is known: it moves to the source.
void ScalarEquation::close_sides(const ScalarTerms& terms,
                                 const std::array<Array3<double>, 3>& mass_flux,
                                 const ScalarBoundary& boundary) {
  for (int side = 0; side < side_count; ++side) {
    const int d = axis_of(side);
    const std::ptrdiff_t s = rows_.stride(d);
    const double h = spacing_[d];
    const double into = is_high(side) ? -1.0 : 1.0;
    const std::optional<double>& value = boundary.side_value[side];
    for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
      const auto face = rows_.offset(i, j, k);
      const auto cell = face + inner_cell_offset(side, s);
      ScalarRow& row = rows_[cell];
      const double entering = std::max(into * mass_flux[d][face], 0.0) / h;
      const double conduct = value ? 2.0 * terms.conductance[cell] / (h * h) : 0.0;
      row.inverse_diagonal += entering + conduct - row.coefficient[side];
      row.coefficient[side] = 0.0;
      row.source += entering * boundary.outside + conduct * value.value_or(0.0);
    });
  }
  if (!boundary.inflow) return;
  for (std::size_t n = 0; n < boundary.inflow->size(); ++n) {
    const InflowFace& inflow = (*boundary.inflow)[n];
    const int d = axis_of(inflow.side);
    const auto face = rows_.offset(inflow.face[0], inflow.face[1], inflow.face[2]);
    const double into = is_high(inflow.side) ? -1.0 : 1.0;
    const double entering = std::max(into * mass_flux[d][face], 0.0) / spacing_[d];
    rows_[face + inner_cell_offset(inflow.side, rows_.stride(d))].source +=
        entering * ((*boundary.inflow_value)[n] - boundary.outside);
  }
}

void ScalarEquation::fix(std::ptrdiff_t cell, double value) {
  ScalarRow& row = rows_[cell];
  row.coefficient.fill(0.0);
  row.source = value;
  row.inverse_diagonal = 1.0;
}

ScalarReport ScalarEquation::solve(Array3<double>& phi) {
  ScalarReport report;
  while (!report.converged && report.sweeps < max_sweeps) {
    sweep(phi, true);
    halo_.exchange({&phi});
    const Change last = sweep(phi, false);
    halo_.exchange({&phi});
    ++report.sweeps;
    report.converged = choices_.positive ? domain_.comm().max(last.excess) <= 0
                                         : domain_.comm().max(last.greatest) <=
                                               choices_.tolerance * domain_.comm().max(last.scale);
  }
  fill_ghost_cells(domain_, phi);
  return report;
}

ScalarEquation::Change ScalarEquation::sweep(Array3<double>& phi, bool forth) const {
  const IndexBox own = domain_.own();
  const std::ptrdiff_t sy = phi.stride(1);
  const std::ptrdiff_t sz = phi.stride(2);
  const int nx = own.extent(0);
  Change change;
  const auto update = [&](std::ptrdiff_t o) {
    const ScalarRow& row = rows_[o];
    const auto& c = row.coefficient;
    const double others = row.source + c[2] * phi[o - sy] + c[3] * phi[o + sy] +
                          c[4] * phi[o - sz] + c[5] * phi[o + sz];
    const double value = (others + c[0] * phi[o - 1] + c[1] * phi[o + 1]) * row.inverse_diagonal;
    const double difference = std::abs(value - phi[o]);
    const double size = std::abs(value);
    phi[o] = value;
    change.greatest = std::max(change.greatest, difference);
    change.scale = std::max(change.scale, size);
    change.excess = std::max(change.excess, difference - choices_.tolerance * size);
  };
  const int rows_y = own.extent(1);
  const int lines = rows_y * own.extent(2);
  for (int n = 0; n < lines; ++n) {
    const int line = forth ? n : lines - 1 - n;
    const std::ptrdiff_t first =
        phi.offset(own.lo[0], own.lo[1] + line % rows_y, own.lo[2] + line / rows_y);
    if (forth)
      for (std::ptrdiff_t o = first; o < first + nx; ++o) update(o);
    else
      for (std::ptrdiff_t o = first + nx - 1; o >= first; --o) update(o);
  }
  return change;
}

}  // namespace gasgrain
