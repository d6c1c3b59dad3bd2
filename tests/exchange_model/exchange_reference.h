// The collisional exchange of one cell, written down from the paper's equations without thought of
// speed: the provisional distribution (51), (52) with its three parcels for each one, which are
// then put together again. Long double. No limits: for cells with solids, collisions and tau > 0.
#pragma once

#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain::reference {

using Real = long double;

struct Cell {
  Real velocity[3] = {0, 0, 0};
  std::vector<Real> ratio;  // lambda_i
  Real liquid_ratio = 0;
  Real rms = 0;
  Real r32 = 0;
  Real particle_fraction = 0;
  Real solid_fraction = 0;
  Real close_packing = 0;
  Real tau = 0;
  Real k_u = 0;
  Real k_t = 0;
  Real temperature = 0;
  Real eta = 0;  // (62)
};

// Integral of the polynomial c_p, from 0 K; films here stay within their range.
inline Real enthalpy(const LiquidSpecies& liquid, Real T) {
  Real sum = 0;
  Real power = T;
  for (std::size_t n = 0; n < liquid.enthalpy.coefficients.size(); ++n, power *= T)
    sum += liquid.enthalpy.coefficients[n] * power / static_cast<Real>(n + 1);
  return sum;
}

inline Real temperature_of(const ExchangeSettings& settings, const std::vector<Real>& mass,
                           Real H) {
  Real low = 1;
  Real high = 1000;
  for (int pass = 0; pass < 200; ++pass) {
    const Real T = (low + high) / 2;
    Real sum = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) sum += mass[i] * enthalpy(settings.species[i], T);
    (sum > H ? high : low) = T;
  }
  return (low + high) / 2;
}

inline Cell cell_of(const Parcels& parcels, std::uint32_t c, const ExchangeSettings& settings,
                    bool film_has_inertia = true) {
  const std::size_t species = parcels.species;
  constexpr Real pi = 3.14159265358979323846264338327950288L;
  Cell cell;
  std::vector<Real> liquid(species, 0);
  Real all_liquid = 0, solid = 0, inertia = 0, square = 0, r2 = 0, r3 = 0, H = 0;
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    if (parcels.cell[p] != c) continue;
    const Real n = parcels.particles[p];
    const Real m = n * parcels.inertia(p, film_has_inertia);
    for (int d = 0; d < 3; ++d) cell.velocity[d] += m * parcels.velocity[3 * p + d];
    inertia += m;
    solid += n * parcels.solid_mass[p];
    Real volume = parcels.solid_volume[p];
    for (std::size_t i = 0; i < species; ++i) {
      const Real film = parcels.film_mass[p * species + i];
      liquid[i] += n * film;
      all_liquid += n * film;
      volume += film / settings.species[i].density;
      if (settings.film_temperature)
        H += n * film * enthalpy(settings.species[i], parcels.film_temperature[p]);
    }
    const Real r = std::cbrt(volume / (4 * pi / 3));
    r2 += n * r * r;
    r3 += n * r * r * r;
    cell.particle_fraction += n * volume / cell_volume;
    cell.solid_fraction += n * parcels.solid_volume[p] / cell_volume;
  }
  for (Real& u : cell.velocity) u /= inertia;                         // (4)
  for (const Real mass : liquid) cell.ratio.push_back(mass / solid);  // (8)
  for (const Real ratio : cell.ratio) cell.liquid_ratio += ratio;     // (10)
  if (settings.film_temperature && all_liquid > 0)
    cell.temperature = temperature_of(settings, liquid, H);  // (9)
  Real spread = 0;
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    if (parcels.cell[p] != c) continue;
    const Real n = parcels.particles[p];
    for (int d = 0; d < 3; ++d) {
      const Real du = parcels.velocity[3 * p + d] - cell.velocity[d];
      square += n * parcels.inertia(p, film_has_inertia) * du * du;
    }
    const Real excess = parcels.film(p) - cell.liquid_ratio * parcels.solid_mass[p];
    spread += n * excess * excess;
  }
  cell.rms = std::sqrt(square / inertia);  // (14)
  cell.r32 = r3 / r2;                      // (19)
  cell.close_packing = std::min<Real>(
      settings.close_packing * cell.particle_fraction / cell.solid_fraction, 1);  // (17)
  cell.tau = cell.r32 / cell.rms * (cell.close_packing - cell.particle_fraction) /
             (cell.close_packing * cell.particle_fraction);  // (13)
  const Real k_sum =
      (settings.k_solid + cell.liquid_ratio * settings.k_liquid) / (1 + cell.liquid_ratio);  // (61)
  cell.k_t = k_sum / settings.time_scale_ratio;                                              // (36)
  cell.k_u = k_sum - cell.k_t;
  cell.eta = all_liquid > 0 ? std::sqrt(spread) / all_liquid : 0;  // (62)
  return cell;
}

// Agglomeration of means.
inline Parcels step(const Parcels& before, std::size_t cells, const ExchangeSettings& settings,
                    double dt, bool film_has_inertia = true) {
  Parcels after = before;
  const std::size_t species = before.species;
  for (std::uint32_t c = 0; c < cells; ++c) {
    const Cell cell = cell_of(before, c, settings, film_has_inertia);
    const Real x_u = dt * cell.k_u / cell.tau;
    const Real x_t = dt * cell.k_t / cell.tau;
    const Real psi_n = 1 / (1 + x_u + x_t);
    const Real psi_t = x_t / (1 + x_t);
    for (std::size_t p = 0; p < before.count(); ++p) {
      if (before.cell[p] != c) continue;
      struct Part {
        Real share;
        bool velocity_relaxed;
        bool film_relaxed;
      };
      std::vector<Real> film(species, 0);
      Real mass = 0, H = 0, momentum[3] = {0, 0, 0};
      for (const Part& part : {Part{psi_n, false, false}, Part{1 - psi_n - psi_t, true, false},
                               Part{psi_t, true, true}}) {
        const Real T = part.film_relaxed ? cell.temperature : before.film_temperature[p];
        Real m = before.solid_mass[p];
        for (std::size_t i = 0; i < species; ++i) {
          const Real one = part.film_relaxed ? cell.ratio[i] * before.solid_mass[p]
                                             : before.film_mass[p * species + i];
          film[i] += part.share * one;
          if (film_has_inertia) m += one;
          if (settings.film_temperature) H += part.share * one * enthalpy(settings.species[i], T);
        }
        mass += part.share * m;
        for (int d = 0; d < 3; ++d)
          momentum[d] += part.share * m *
                         (part.velocity_relaxed ? cell.velocity[d] : before.velocity[3 * p + d]);
      }
      for (std::size_t i = 0; i < species; ++i)
        after.film_mass[p * species + i] = static_cast<double>(film[i]);
      for (int d = 0; d < 3; ++d)
        after.velocity[3 * p + d] = static_cast<double>(momentum[d] / mass);
      if (settings.film_temperature && after.film(p) > 0)
        after.film_temperature[p] = static_cast<double>(temperature_of(settings, film, H));
    }
  }
  return after;
}

}  // namespace gasgrain::reference
