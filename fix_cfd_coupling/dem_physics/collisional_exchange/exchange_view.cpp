#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_view.h"

#include <cmath>
#include <string_view>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

constexpr double greatest = 1e30;  // beyond what any unit slip of a mass or a temperature makes

// least: the value itself is allowed unless `above`.
void check(double value, bool above, std::size_t parcel, std::string_view what,
           std::string_view remedy) {
  if (above ? value > 0.0 && value < greatest : value >= 0.0 && value < greatest) return;
  fail("parcel {} of this rank: its {} is {}, must be {} 0 and finite. {}", parcel, what, value,
       above ? "above" : "at least", remedy);
}

}  // namespace

void check_view(const ExchangeView& view, std::size_t species, const IndexBox& tile) {
  for (std::size_t p = 0; p < view.count; ++p) {
    if (view.cell[p] == no_cell) continue;
    if (view.cell[p] >= tile.size())
      fail("parcel {} of this rank: its cell {} is not among the {} of the tile.", p, view.cell[p],
           tile.size());
    if (view.particles)
      check(view.particles[p], true, p, "number of particles",
            "Give the parcels their number of particles before the run.");
    check(view.solid_mass[p], false, p, "solid mass [kg]",
          "Give it a density and a radius; a droplet has a vanishing core.");
    check(view.solid_volume[p], false, p, "solid volume [m3]",
          "Give it a density and a radius; a droplet has a vanishing core.");
    for (std::size_t i = 0; i < species; ++i)
      check(view.film_mass[p * species + i], false, p, "film mass [kg]",
            "Set the films to 0 for dry particles.");
    if (view.film_temperature)
      check(view.film_temperature[p], true, p, "film temperature [K]",
            "Temperatures are in kelvin; set them before the run.");
  }
}

}  // namespace gasgrain
