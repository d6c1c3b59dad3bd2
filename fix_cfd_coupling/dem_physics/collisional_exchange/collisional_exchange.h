// Exchange of film mass, momentum and film enthalpy by collisions: two relaxations to local
// equilibrium, of velocities alone and of all film properties with them.
//
//   df/dt = (f_eq,u - f) K_u / tau_coll + (f_eq,t - f) K_t / tau_coll               (3), (11), (12)
//
// Source: P.J. O'Rourke, P. Zhao, D. Snider, Chem. Eng. Sci. 64 (2009) 1784; numbers in brackets
// are its equations. In each cell: equilibrium (4), (8)-(10), collision time (13)-(19)
// (collision_time.h), implicit update with numerical agglomeration (53)-(57) (relaxation.h).
//
// In: an ExchangeView, a step [s], the volume of a cell [m3]. Out: its film masses, velocities and
// film temperatures. Conserved in each cell to round-off: mass of each species, momentum, film
// enthalpy; no value leaves the range between its old one and that of equilibrium (58)-(60).
// Assumes what the paper does: liquid spreads in proportion to solid mass, a film is of one
// temperature and composition, densities are constant, nothing is exchanged across cells.
// Valid for every packing and step: the update is implicit, tau is 0 at close packing and beyond.
// Deviations, all of them where the paper is silent (docs/collisional-exchange.md):
//   - velocities that agree to round-off count as equal: nothing is exchanged, at close packing too
//   - liquid in a cell without any solid mass, where (8) has no value, keeps its films
//   - film_has_inertia false and momentum off, for grains whose contacts are resolved
#pragma once

#include <cstddef>
#include <vector>

#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_cells.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_settings.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_view.h"

namespace gasgrain {

// Of one step and this rank's parcels: the ranks' reports add up.
struct ExchangeReport {
  std::size_t parcels = 0;                    // that took part
  std::size_t at_close_packing = 0;           // parcels in cells with collisions and tau 0
  std::size_t films_without_solid = 0;        // parcels in cells of liquid without solid mass
  std::size_t films_below_zero = 0;           // parcels that came with a negative film mass
  std::size_t temperatures_beyond_range = 0;  // films where the c_p of a species is held at an end
  double liquid_moved = 0.0;                  // sum N_p |change of M_f,i| / 2 [kg]
  double energy_lost = 0.0;                   // sum N_p (loss of M_p u^2 / 2) [J]

  ExchangeReport& operator+=(const ExchangeReport& other);
};

class CollisionalExchange {
 public:
  explicit CollisionalExchange(const ExchangeSettings& settings);

  // Collective over the ranks of `sum`, which is called twice and must leave the same bits on all
  // ranks that share a cell.
  ExchangeReport step(const ExchangeView& view, const IndexBox& tile, double cell_volume, double dt,
                      const SumOverRanks& sum);

  // Of the last step.
  [[nodiscard]] const ExchangeCells& cells() const { return cells_; }

 private:
  void make_room(const IndexBox& tile);
  void deposit(const ExchangeView& view);
  void find_equilibrium(double cell_volume);
  void deposit_fluctuations(const ExchangeView& view);
  void find_relaxations(double dt);
  void relax(const ExchangeView& view);

  ExchangeSettings settings_;
  ExchangeCells cells_;
};

}  // namespace gasgrain
