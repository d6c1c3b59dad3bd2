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
  // What the particles of a cell keep and gain in this step.
  struct CellRelaxation {
    double velocity[3] = {0.0, 0.0, 0.0};  // u_eq [m/s]
    double velocity_kept = 1.0;
    double film_kept = 1.0;
    double enthalpy_gain = 0.0;     // for each kg of solid [J/kg]
    double film_temperature = 0.0;  // T_f,eq [K]
  };

  [[nodiscard]] std::size_t species() const { return settings_.species.size(); }
  [[nodiscard]] double film_of(const ExchangeView& view, std::size_t p) const;
  [[nodiscard]] double inertia_of(const ExchangeView& view, std::size_t p) const;  // M_p

  void check_fits(const ExchangeView& view) const;
  void make_room(const IndexBox& tile);
  void deposit(const ExchangeView& view);
  void find_equilibrium(const ExchangeView& view, double cell_volume);
  void deposit_fluctuations(const ExchangeView& view);
  void find_relaxations(const ExchangeView& view, double dt);
  void relax(const ExchangeView& view);
  void relax_film(const ExchangeView& view, std::size_t p, double n, const CellRelaxation& cell);

  ExchangeSettings settings_;
  std::vector<double> densities_;  // of the species [kg/m3]
  ExchangeCells cells_;
  ExchangeReport report_;

  std::vector<Array3<double>*> sums_;  // all that is added up over the ranks at first
  std::vector<Array3<double>*> fluctuations_;
  Array3<double> surface_;      // sum N_p V_p^(2/3) [m2]
  Array3<double> enthalpy_;     // sum N_p sum M_f,i h_i [J]
  Array3<double> fluctuation_;  // sum N_p M_p (u - u_eq)^2 [J]
  std::vector<std::uint32_t> own_parcels_;
  std::vector<CellRelaxation> relaxations_;
  std::vector<double> film_gains_;  // for each kg of solid, cells x species
};

}  // namespace gasgrain
