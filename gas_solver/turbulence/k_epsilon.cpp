#include "gas_solver/turbulence/k_epsilon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas_solver/boundary/ghosts.h"
#include "gas_solver/turbulence/launder_spalding.h"
#include "gas_solver/turbulence/strain_rate.h"

namespace gasgrain {
namespace {

using namespace launder_spalding;

constexpr double least_k = 1e-16;                 // [m2/s2]
constexpr double least_e = 1e-20;                 // [m2/s3]
constexpr double greatest_viscosity_ratio = 1e5;  // mu_t / mu

// Square of the velocity along a wall at the centre of its cell, relative to the wall.
double squared_slip(const CellVector& velocity, const WallSide& wall, std::ptrdiff_t cell) {
  double sum = 0;
  for (const int d : plane_axes(axis_of(wall.side))) {
    const Array3<double>& u = velocity[d];
    const double slip = 0.5 * (u[cell] + u[cell + u.stride(d)]) - wall.velocity[d];
    sum += slip * slip;
  }
  return sum;
}

void add(const ScalarReport& equation, TurbulenceReport& report) {
  report.not_converged += equation.converged ? 0 : 1;
}

}  // namespace

KEpsilon::KEpsilon(const Domain& domain, const GasInput& input, Halo& halo)
    : domain_(domain),
      halo_(halo),
      constant_density_(input.density),
      density_(ConstantQuantity{input.density}),
      molecular_(input.viscosity),
      inflow_(input),
      walls_(domain, input),
      equation_(domain, halo, {input.convection != Convection::upwind, true, input.tolerance}),
      terms_(domain.box()),
      k_(domain.box()),
      e_(domain.box()),
      viscosity_(domain.box()),
      production_(domain.box()),
      rate_(domain.box()) {
  if (molecular_ > 0) find_walls();
  set_uniform(inflow_.ambient());
}

void KEpsilon::find_walls() {
  Array3<char> walls(domain_.box());
  Array3<double> per_distance(domain_.box());
  const auto each = [&](const auto& visit) {
    for (std::size_t n = 0; n < walls_.sides().size(); ++n) {
      const WallSide& wall = walls_.sides()[n];
      for_each_cell(intersection(wall.is_wall.box(), domain_.own()), [&](int i, int j, int k) {
        if (wall.is_wall(i, j, k)) visit(n, wall, i, j, k);
      });
    }
  };
  each([&](std::size_t, const WallSide& wall, int i, int j, int k) {
    ++walls(i, j, k);
    per_distance(i, j, k) += 1.0 / wall.distance;
  });
  each([&](std::size_t n, const WallSide& wall, int i, int j, int k) {
    contacts_.push_back(
        {walls.offset(i, j, k), n, wall.is_wall.offset(i, j, k), 1.0 / walls(i, j, k)});
  });
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = walls.offset(i, j, k);
    if (walls[o] > 0) wall_cells_.push_back({o, per_distance[o] / walls[o]});
  });
}

void KEpsilon::set_uniform(const TurbulentValues& values) {
  k_.fill(values.k);
  e_.fill(values.e);
  TurbulenceReport unused;
  close(unused);
}

void KEpsilon::restore(const GasState& state) {
  density_ = quantity(state.density, constant_density_);
  TurbulenceReport unused;
  close(unused);
}

TurbulenceReport KEpsilon::update(const GasState& state, double step,
                                  const std::vector<InflowFace>& inflow) {
  TurbulenceReport report;
  density_ = quantity(state.density, constant_density_);
  // The projection has changed it since the last step.
  if (state.density.size() > 0) set_viscosity();
  inflow_.update(inflow);
  set_rates(state);
  set_rates_at_walls(state);
  for (std::size_t n = 0; n < terms_.mass.size(); ++n)
    terms_.mass[n] = density(static_cast<std::ptrdiff_t>(n)) * state.void_fraction[n];

  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = k_.offset(i, j, k);
    terms_.source[o] = state.void_fraction[o] * production_[o];
    terms_.sink[o] = terms_.mass[o] * rate_[o];
  });
  set_conductance(state, sigma_k);
  equation_.assemble(terms_, state.mass_flux, step, k_,
                     {&inflow, &inflow_.k(), inflow_.ambient().k, {}});
  add(equation_.solve(k_), report);

  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = k_.offset(i, j, k);
    terms_.source[o] *= c_1 * rate_[o];
    terms_.sink[o] *= c_2;
  });
  set_conductance(state, sigma_e);
  equation_.assemble(terms_, state.mass_flux, step, e_,
                     {&inflow, &inflow_.e(), inflow_.ambient().e, {}});
  for (const WallCell& wall : wall_cells_)
    equation_.fix(wall.cell,
                  dissipation(std::max(k_[wall.cell], least_k), kappa / wall.per_distance));
  add(equation_.solve(e_), report);
  close(report);
  return report;
}

void KEpsilon::set_rates(const GasState& state) {
  const StrainRate strain(state.velocity, domain_.grid().spacing());
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = k_.offset(i, j, k);
    production_[o] = (viscosity_[o] - molecular_) * strain.squared(o);
    rate_[o] = e_[o] / k_[o];
  });
}

// e is given there, so that rate_ serves k alone.
void KEpsilon::set_rates_at_walls(const GasState& state) {
  for (const WallCell& wall : wall_cells_) production_[wall.cell] = rate_[wall.cell] = 0;
  for (const Contact& at : contacts_) {
    const WallSide& wall = walls_.sides()[at.wall];
    const double y = wall.distance;
    production_[at.cell] +=
        at.share * wall.coefficient[at.place] * squared_slip(state.velocity, wall, at.cell) / y;
    rate_[at.cell] +=
        at.share * wall_dissipation_rate(density(at.cell), molecular_, k_[at.cell], y);
  }
}

void KEpsilon::set_conductance(const GasState& state, double sigma) {
  const double of_molecular = molecular_ * (1.0 - 1.0 / sigma);
  for (std::size_t n = 0; n < viscosity_.size(); ++n)
    terms_.conductance[n] = state.void_fraction[n] * (of_molecular + viscosity_[n] / sigma);
}

// What follows from k and e, and their layers.
void KEpsilon::close(TurbulenceReport& report) {
  std::vector<double> counts(2, 0.0);
  for_each_cell(domain_.own(), [&](int i, int j, int k) {
    const auto o = k_.offset(i, j, k);
    counts[0] += (k_[o] < least_k ? 1 : 0) + (e_[o] < least_e ? 1 : 0);
    k_[o] = std::max(k_[o], least_k);
    e_[o] = std::max(e_[o], least_e);
    if (eddy_viscosity(density(o), k_[o], e_[o]) > greatest_viscosity()) ++counts[1];
  });
  domain_.comm().sum_in_place(counts);
  report.floored += std::lround(counts[0]);
  report.capped += std::lround(counts[1]);
  halo_.exchange({&k_, &e_});
  fill_ghost_cells(domain_, k_);
  fill_ghost_cells(domain_, e_);
  set_viscosity();
}

double KEpsilon::greatest_viscosity() const {
  return molecular_ > 0 ? greatest_viscosity_ratio * molecular_
                        : std::numeric_limits<double>::infinity();
}

void KEpsilon::set_viscosity() {
  const double greatest = greatest_viscosity();
  for (std::size_t n = 0; n < viscosity_.size(); ++n)
    viscosity_[n] =
        molecular_ +
        std::min(eddy_viscosity(density(static_cast<std::ptrdiff_t>(n)), k_[n], e_[n]), greatest);
  if (molecular_ <= 0) return;
  for (WallSide& wall : walls_.sides())
    for_each_cell(wall.is_wall.box(), [&](int i, int j, int k) {
      if (wall.is_wall(i, j, k))
        wall.coefficient(i, j, k) =
            wall_coefficient(density(k_.offset(i, j, k)), molecular_, k_(i, j, k), wall.distance);
    });
}

}  // namespace gasgrain
