// The part of the collisional exchange that goes over cells: room, equilibrium, collision time.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/collision_time.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/film_temperature.h"

namespace gasgrain {

namespace {

constexpr double pi = 3.14159265358979323846;

// Velocities of a cell count as equal when u'_rms is below this share of |u_eq|. Sums over a cell
// of 1e3 parcels leave 1e-14 to 1e-13 of it where all are equal; at close packing, where tau is 0,
// such a remainder would mix all films at once.
constexpr double equal_velocities = 1e-12;

}  // namespace

void CollisionalExchange::make_room(const IndexBox& tile) {
  sums_.clear();
  fluctuations_ = {&fluctuation_};
  const auto add = [&](Array3<double>& field) { sums_.push_back(&field); };
  for (Array3<double>& u : cells_.equilibrium_velocity) add(u);
  add(cells_.solid_mass);
  add(cells_.solid_fraction);
  add(surface_);
  for (Array3<double>& mass : cells_.species_mass) add(mass);
  if (settings_.film_temperature) add(enthalpy_);
  const auto clear = [&](Array3<double>& field, double value = 0.0) {
    if (field.box() != tile || field.size() != tile.size())
      field = Array3<double>(tile, value);
    else
      field.fill(value);
  };
  for (Array3<double>* field : sums_) clear(*field);
  clear(fluctuation_);
  clear(cells_.rms_velocity);
  clear(cells_.collision_time, std::numeric_limits<double>::infinity());
  clear(cells_.particle_fraction);
  clear(cells_.close_packing);
  clear(cells_.sauter_radius);
  clear(cells_.liquid_ratio);
  for (Array3<double>& ratio : cells_.species_ratio) clear(ratio);
  if (settings_.film_temperature) clear(cells_.film_temperature);
  own_parcels_.assign(tile.size(), 0);
  relaxations_.resize(tile.size());
  film_gains_.resize(tile.size() * species());
}

void CollisionalExchange::find_equilibrium(const ExchangeView& view, double cell_volume) {
  const double radius_of_volume = std::cbrt(3.0 / (4.0 * pi));  // r = (3 V / (4 pi))^(1/3)
  for (std::size_t c = 0; c < cells_.solid_mass.size(); ++c) {
    const double solid = cells_.solid_mass[c];
    double volume = cells_.solid_fraction[c];
    double liquid = 0.0;
    for (std::size_t i = 0; i < species(); ++i) {
      const double mass = cells_.species_mass[i][c];
      liquid += mass;
      volume += mass / densities_[i];
      cells_.species_ratio[i][c] = mass > 0.0 ? mass / solid : 0.0;
    }
    cells_.liquid_ratio[c] = liquid > 0.0 ? liquid / solid : 0.0;
    const double inertia = view.film_has_inertia ? solid + liquid : solid;
    for (Array3<double>& u : cells_.equilibrium_velocity) u[c] = inertia > 0.0 ? u[c] / inertia : 0;
    cells_.solid_fraction[c] /= cell_volume;
    cells_.particle_fraction[c] = volume / cell_volume;
    if (volume > 0.0) {
      cells_.close_packing[c] = close_packing_of_wet(
          settings_.close_packing, cells_.particle_fraction[c], cells_.solid_fraction[c]);
      cells_.sauter_radius[c] = radius_of_volume * volume / surface_[c];
    }
    if (settings_.film_temperature)
      cells_.film_temperature[c] =
          liquid > 0.0
              ? temperature_of(
                    settings_.species, [&](std::size_t i) { return cells_.species_mass[i][c]; },
                    enthalpy_[c], {0.0, std::numeric_limits<double>::infinity()},
                    *settings_.film_temperature)
              : 0.0;
  }
}

void CollisionalExchange::find_relaxations(const ExchangeView& view, double dt) {
  for (std::size_t c = 0; c < relaxations_.size(); ++c) {
    CellRelaxation& cell = relaxations_[c];
    cell = {};
    const double solid = cells_.solid_mass[c];
    double liquid = 0.0;
    for (const Array3<double>& mass : cells_.species_mass) liquid += mass[c];
    double* gains = film_gains_.data() + c * species();
    std::fill(gains, gains + species(), 0.0);
    const double inertia = view.film_has_inertia ? solid + liquid : solid;
    if (!(inertia > 0.0)) continue;

    double speed = 0.0;
    for (int d = 0; d < 3; ++d) {
      cell.velocity[d] = cells_.equilibrium_velocity[d][c];
      speed += cell.velocity[d] * cell.velocity[d];
    }
    const double rms = std::sqrt(fluctuation_[c] / inertia);
    cells_.rms_velocity[c] = rms > equal_velocities * std::sqrt(speed) ? rms : 0.0;
    const double frequency =
        collision_frequency(cells_.rms_velocity[c], cells_.sauter_radius[c],
                            cells_.particle_fraction[c], cells_.close_packing[c]);
    cells_.collision_time[c] = 1.0 / frequency;
    if (std::isinf(frequency)) report_.at_close_packing += own_parcels_[c];

    // (61), without its lambda, which may be infinite; (36) parts the sum.
    const double k_sum =
        (settings_.k_solid * solid + settings_.k_liquid * liquid) / (solid + liquid);
    const double k_t = k_sum / settings_.time_scale_ratio;
    const double collisions = dt * frequency;
    const Relaxation r = relaxation(product_or_zero(k_sum - k_t, collisions),
                                    product_or_zero(k_t, collisions), settings_.agglomeration);
    cell.velocity_kept = r.velocity_kept;
    if (solid > 0.0) {
      cell.film_kept = r.film_kept;
      for (std::size_t i = 0; i < species(); ++i)
        gains[i] = r.film_given * cells_.species_ratio[i][c];
    } else {
      report_.films_without_solid += own_parcels_[c];
    }
    if (settings_.film_temperature && liquid > 0.0) {
      cell.film_temperature = cells_.film_temperature[c];
      cell.enthalpy_gain = film_enthalpy(
          settings_.species, [&](std::size_t i) { return gains[i]; }, cell.film_temperature);
    }
  }
}

}  // namespace gasgrain
