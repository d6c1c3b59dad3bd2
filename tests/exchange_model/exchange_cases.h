// Clouds of parcels for the tests of the collisional exchange, and what they hold.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"

namespace gasgrain {

inline void on_one_rank(const std::vector<Array3<double>*>& /*fields*/) {}

inline IndexBox row_of_cells(int cells) {
  return {{0, 0, 0}, {cells, 1, 1}};
}

// What a host would own.
struct Parcels {
  std::size_t species = 0;
  std::vector<double> particles, solid_mass, solid_volume, film_mass, velocity, film_temperature;
  std::vector<std::uint32_t> cell;

  [[nodiscard]] std::size_t count() const { return cell.size(); }
  [[nodiscard]] double film(std::size_t p) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < species; ++i) sum += film_mass[p * species + i];
    return sum;
  }
  [[nodiscard]] double inertia(std::size_t p, bool film_has_inertia = true) const {
    return solid_mass[p] + (film_has_inertia ? film(p) : 0.0);
  }

  void add(std::uint32_t in_cell, double n, double core_mass, double core_volume,
           const std::vector<double>& films, const Vec3& u, double T = 300.0) {
    cell.push_back(in_cell);
    particles.push_back(n);
    solid_mass.push_back(core_mass);
    solid_volume.push_back(core_volume);
    film_mass.insert(film_mass.end(), films.begin(), films.end());
    velocity.insert(velocity.end(), u.data(), u.data() + 3);
    film_temperature.push_back(T);
  }
  void add_from(const Parcels& other, std::size_t p, double n) {
    const auto film_at = other.film_mass.begin() + static_cast<std::ptrdiff_t>(p * species);
    add(other.cell[p], n, other.solid_mass[p], other.solid_volume[p],
        {film_at, film_at + static_cast<std::ptrdiff_t>(species)},
        Vec3(other.velocity.data() + 3 * p), other.film_temperature[p]);
  }

  ExchangeView view() {
    ExchangeView v;
    v.count = count();
    v.particles = particles.data();
    v.solid_mass = solid_mass.data();
    v.solid_volume = solid_volume.data();
    v.film_mass = film_mass.data();
    v.velocity = velocity.data();
    v.film_temperature = film_temperature.data();
    v.cell = cell.data();
    return v;
  }
};

inline ExchangeSettings settings_of(std::size_t species, bool warm = false) {
  // Water, ethanol and an oil, with heats that change with temperature as real ones do or more.
  const LiquidSpecies liquids[] = {{"water", 998.0, {{4900.0, -4.5, 0.0072}, 250.0, 450.0}},
                                   {"ethanol", 789.0, {{900.0, 5.2}, 250.0, 450.0}},
                                   {"oil", 880.0, {{1900.0}, 250.0, 450.0}}};
  ExchangeSettings settings;
  settings.species.assign(liquids, liquids + species);
  if (warm) settings.film_temperature = 300.0;
  return settings;
}

constexpr double cell_volume = 1e-6;  // [m3]

// Solids of 100 um, more or less, 1000 to 2500 kg/m3, wet and dry; droplets on vanishing cores.
// theta_s is about `fraction` in each cell.
inline Parcels random_parcels(int cells, int parcels_a_cell, std::size_t species, unsigned seed,
                              double fraction = 0.2) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::normal_distribution<double> normal;
  constexpr double pi = 3.14159265358979323846;
  Parcels parcels;
  parcels.species = species;
  for (int c = 0; c < cells; ++c) {
    for (int k = 0; k < parcels_a_cell; ++k) {
      const bool droplet = species > 0 && share(random) < 0.15;
      const double kind = share(random);
      const double radius = droplet ? 1e-10 : 5e-5 * (0.5 + share(random));
      const double volume = 4.0 / 3.0 * pi * radius * radius * radius;
      const double density = 1000.0 + 1500.0 * share(random);
      std::vector<double> films;
      for (std::size_t i = 0; i < species; ++i)
        films.push_back(droplet      ? 5e-10 * share(random)
                        : kind < 0.3 ? 0.0
                                     : 0.3 * share(random) * volume * density);
      const double body = droplet ? 5e-13 : volume;
      const double n = fraction * cell_volume / parcels_a_cell / body * (0.5 + share(random));
      parcels.add(static_cast<std::uint32_t>(c), n, volume * density, volume, films,
                  Vec3(1.0 + normal(random), 0.5 * normal(random), normal(random) - 2.0),
                  280.0 + 100.0 * share(random));
    }
  }
  return parcels;
}

// What a cell holds: species, momentum, enthalpy of the films, solid mass, kinetic energy.
struct CellContent {
  std::vector<double> species;
  Vec3 momentum = Vec3::Zero();
  double momentum_scale = 0.0;  // sum of magnitudes, for tolerances
  double enthalpy = 0.0;
  double solid = 0.0;
  double energy = 0.0;
};

inline std::vector<CellContent> contents(const Parcels& parcels, std::size_t cells,
                                         const ExchangeSettings& settings,
                                         bool film_has_inertia = true) {
  std::vector<CellContent> all(cells);
  for (CellContent& one : all) one.species.assign(parcels.species, 0.0);
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    CellContent& one = all[parcels.cell[p]];
    const double n = parcels.particles[p];
    const Vec3 u(parcels.velocity.data() + 3 * p);
    const double mass = n * parcels.inertia(p, film_has_inertia);
    for (std::size_t i = 0; i < parcels.species; ++i) {
      const double film = parcels.film_mass[p * parcels.species + i];
      one.species[i] += n * film;
      if (settings.film_temperature)
        one.enthalpy +=
            n * film * settings.species[i].enthalpy.enthalpy(parcels.film_temperature[p]);
    }
    one.momentum += mass * u;
    one.momentum_scale += mass * u.norm();
    one.solid += n * parcels.solid_mass[p];
    one.energy += 0.5 * mass * u.squaredNorm();
  }
  return all;
}

}  // namespace gasgrain
