#include "fix_cfd_coupling/dem_physics/collisional_exchange/liquid_spread.h"

#include <cmath>

namespace gasgrain {

void liquid_spread(const ExchangeView& view, const ExchangeCells& cells, const SumOverRanks& sum,
                   Array3<double>& eta) {
  const IndexBox& tile = cells.solid_mass.box();
  if (eta.box() != tile || eta.size() != tile.size())
    eta = Array3<double>(tile);
  else
    eta.fill(0.0);
  const std::size_t species = cells.species_mass.size();
  for (std::size_t p = 0; p < view.count; ++p) {
    const std::uint32_t c = view.cell[p];
    if (c == no_cell || !(cells.solid_mass[c] > 0.0)) continue;
    double film = 0.0;
    for (std::size_t i = 0; i < species; ++i) film += view.film_mass[p * species + i];
    const double excess = film - cells.liquid_ratio[c] * view.solid_mass[p];
    eta[c] += (view.particles ? view.particles[p] : 1.0) * excess * excess;
  }
  sum({&eta});
  for (std::size_t c = 0; c < eta.size(); ++c) {
    double liquid = 0.0;
    for (const Array3<double>& mass : cells.species_mass) liquid += mass[c];
    eta[c] = liquid > 0.0 ? std::sqrt(eta[c]) / liquid : 0.0;
  }
}

}  // namespace gasgrain
