#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/film_temperature.h"

namespace gasgrain {

namespace {

double squared(const double* u) {
  return u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
}

}  // namespace

ExchangeReport& ExchangeReport::operator+=(const ExchangeReport& other) {
  parcels += other.parcels;
  at_close_packing += other.at_close_packing;
  films_without_solid += other.films_without_solid;
  films_below_zero += other.films_below_zero;
  temperatures_beyond_range += other.temperatures_beyond_range;
  liquid_moved += other.liquid_moved;
  energy_lost += other.energy_lost;
  return *this;
}

CollisionalExchange::CollisionalExchange(const ExchangeSettings& settings) : settings_(settings) {
  cells_.species_mass.resize(species());
  cells_.species_ratio.resize(species());
  for (const LiquidSpecies& one : settings_.species) densities_.push_back(one.density);
}

ExchangeReport CollisionalExchange::step(const ExchangeView& view, const IndexBox& tile,
                                         double cell_volume, double dt, const SumOverRanks& sum) {
  check_fits(view);
  report_ = {};
  make_room(tile);
  deposit(view);
  sum(sums_);
  find_equilibrium(view, cell_volume);
  deposit_fluctuations(view);
  sum(fluctuations_);
  find_relaxations(view, dt);
  relax(view);
  return report_;
}

void CollisionalExchange::check_fits(const ExchangeView& view) const {
  if (!settings_.momentum && view.film_has_inertia)
    fail(
        "momentum off: the films here are part of the particles' inertia, and liquid that moves "
        "takes momentum with it. Leave out 'momentum off'; it is for grains whose contacts are "
        "resolved.");
  if (view.count > 0 && settings_.film_temperature && !view.film_temperature)
    fail("film_temperature is set, but the particles have no film temperatures to work on.");
}

double CollisionalExchange::film_of(const ExchangeView& view, std::size_t p) const {
  double film = 0.0;
  for (std::size_t i = 0; i < species(); ++i) film += view.film_mass[p * species() + i];
  return film;
}

double CollisionalExchange::inertia_of(const ExchangeView& view, std::size_t p) const {
  return view.film_has_inertia ? view.solid_mass[p] + film_of(view, p) : view.solid_mass[p];
}

void CollisionalExchange::deposit(const ExchangeView& view) {
  const std::size_t count = species();
  for (std::size_t p = 0; p < view.count; ++p) {
    const std::uint32_t c = view.cell[p];
    if (c == no_cell) continue;
    ++own_parcels_[c];
    ++report_.parcels;
    const double n = view.particles ? view.particles[p] : 1.0;
    double volume = view.solid_volume[p];
    double film = 0.0;
    bool below_zero = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double mass = view.film_mass[p * count + i];
      below_zero = below_zero || mass < 0.0;
      film += mass;
      volume += mass / densities_[i];
      cells_.species_mass[i][c] += n * mass;
    }
    report_.films_below_zero += below_zero;
    const double root = std::cbrt(volume);
    surface_[c] += n * root * root;
    const double solid = view.solid_mass[p];
    const double momentum = n * (view.film_has_inertia ? solid + film : solid);
    const double* u = view.velocity + 3 * p;
    for (int d = 0; d < 3; ++d) cells_.equilibrium_velocity[d][c] += momentum * u[d];
    cells_.solid_mass[c] += n * solid;
    cells_.solid_fraction[c] += n * view.solid_volume[p];
    if (settings_.film_temperature && film > 0.0) {
      const double T = view.film_temperature[p];
      bool beyond = false;
      for (const LiquidSpecies& one : settings_.species)
        beyond = beyond || !one.enthalpy.within_range(T);
      report_.temperatures_beyond_range += beyond;
      enthalpy_[c] += n * film_enthalpy(
                              settings_.species,
                              [&](std::size_t i) { return view.film_mass[p * count + i]; }, T);
    }
  }
}

void CollisionalExchange::deposit_fluctuations(const ExchangeView& view) {
  for (std::size_t p = 0; p < view.count; ++p) {
    const std::uint32_t c = view.cell[p];
    if (c == no_cell) continue;
    const double n = view.particles ? view.particles[p] : 1.0;
    double square = 0.0;
    for (int d = 0; d < 3; ++d) {
      const double u = view.velocity[3 * p + d] - cells_.equilibrium_velocity[d][c];
      square += u * u;
    }
    fluctuation_[c] += n * inertia_of(view, p) * square;
  }
}

void CollisionalExchange::relax(const ExchangeView& view) {
  for (std::size_t p = 0; p < view.count; ++p) {
    const std::uint32_t c = view.cell[p];
    if (c == no_cell) continue;
    const CellRelaxation& cell = relaxations_[c];
    if (cell.velocity_kept == 1.0) continue;  // no collisions
    const double n = view.particles ? view.particles[p] : 1.0;
    const double inertia_before = inertia_of(view, p);
    relax_film(view, p, n, cell);
    if (!settings_.momentum) continue;
    const double inertia = inertia_of(view, p);
    const double kept = inertia > 0.0 ? cell.velocity_kept * inertia_before / inertia : 0.0;
    double* u = view.velocity + 3 * p;
    double energy = inertia_before * squared(u);
    for (int d = 0; d < 3; ++d) u[d] = cell.velocity[d] + kept * (u[d] - cell.velocity[d]);
    energy -= inertia * squared(u);
    report_.energy_lost += 0.5 * n * energy;
  }
}

void CollisionalExchange::relax_film(const ExchangeView& view, std::size_t p, double n,
                                     const CellRelaxation& cell) {
  if (cell.film_kept == 1.0) return;
  const std::size_t count = species();
  double* film = view.film_mass + p * count;
  const auto mass = [&](std::size_t i) { return film[i]; };
  const double solid = view.solid_mass[p];
  const double* gains =
      film_gains_.data() + static_cast<std::size_t>(&cell - relaxations_.data()) * count;
  const bool warm = settings_.film_temperature.has_value();
  const double before = warm ? film_of(view, p) : 0.0;
  const double T = warm ? view.film_temperature[p] : 0.0;
  double enthalpy = cell.enthalpy_gain * solid;
  if (warm && before > 0.0) enthalpy += cell.film_kept * film_enthalpy(settings_.species, mass, T);
  double moved = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double kept = cell.film_kept * film[i] + gains[i] * solid;
    moved += std::abs(kept - film[i]);
    film[i] = kept;
  }
  report_.liquid_moved += 0.5 * n * moved;
  if (!warm) return;
  const double after = film_of(view, p);
  if (!(after > 0.0)) return;
  const double T_eq = cell.film_temperature;
  if (!(before > 0.0)) {
    view.film_temperature[p] = T_eq;
    return;
  }
  const double own = cell.film_kept * before / after;
  view.film_temperature[p] =
      temperature_of(settings_.species, mass, enthalpy, {std::min(T, T_eq), std::max(T, T_eq)},
                     own * T + (1.0 - own) * T_eq);
}

}  // namespace gasgrain
