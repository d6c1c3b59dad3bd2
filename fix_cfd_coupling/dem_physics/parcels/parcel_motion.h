// Moves parcels over a step so that no cell's solid fraction passes close packing by more than 1 %.
//
//   x -> x + alpha o d,   d: the way of the free flight (wall_rebound.h), alpha: three numbers from
//   0 to 1 a parcel, one an axis
//
// Solids are deposited at the ends of the ways (trilinear). Where a cell is then above its limit
// (0.995 theta_cp, or what it held before where that is more), the ways that raise its content are
// shortened along the axes along which they do:
//
//   alpha_c = (limit - content before + outflow) / inflow
//
// Shortened ways may leave other cells fuller, so this is repeated; alphas only fall. It ends when
// no cell is above 1.01 theta_cp (or above what it held before); after `soft_passes` the ways into
// the cells that still are end where they began, axis by axis, and if even that does not suffice no
// parcel moves at all: where the parcels were is allowed. Source: our own; the shares are those of
// flux-corrected transport (Zalesak, J. Comput. Phys. 31 (1979) 335, (10)-(13)) with the outflow
// counted, without which a packed bed could not move as a plug.
//
// The first three passes aim at 0.995, where the stress, 7 kPa, carries half a metre of glass.
//
// Velocity: what is stopped along an axis takes over the mean motion of the solids around it,
//
//   v_d -> alpha v_d + (1 - alpha) u_d,   u_d: mean of the shortened ways over dt, bounded by 0 and
//   v_d
//
// (mass-weighted, trilinear), so that a parcel that runs into a bed at rest stops (inelastic), and
// one that is held up for a step inside of a moving plug stays with it. Kinetic energy never rises.
// The momentum lost is reported.
// Cells that are fuller than the bound at the beginning of a run cannot travel: what they hold is
// spread by the stress or stays. Begin below close packing.
// Parcels without solids (droplets: their core is less than 1e-9 of them) take no part: they go
// between the grains.
// Assumptions: the tile holds the trilinear stencils of all parcels before and after the step; a
// way that leaves it is cut at its rim and counted. Same result on any number of ranks up to
// round-off.
#pragma once

#include <functional>
#include <vector>

#include "coupling/base/array3.h"
#include "coupling/base/tile_frame.h"
#include "fix_cfd_coupling/dem_physics/cell_sums.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_view.h"
#include "fix_cfd_coupling/dem_physics/parcels/wall_rebound.h"

namespace gasgrain {

// The sum of a number over all ranks; collective.
using TotalOverRanks = std::function<double(double)>;

// Sums over the parcels of this rank unless told otherwise.
struct MotionReport {
  std::size_t rebounds = 0;           // from walls
  std::size_t limited = 0;            // parcels whose way was shortened at close packing
  std::size_t stopped = 0;            // of these, parcels with an axis stopped by a hard pass
  std::size_t cut_at_tile = 0;        // ways that would have left the tile
  std::size_t outside = 0;            // parcels that ended beyond an open side
  int passes = 0;                     // the same on all ranks
  bool all_held = false;              // the passes did not suffice, no parcel moved; on all ranks
  double greatest_fraction = 0.0;     // of the tile, after the step
  Vec3 lost_momentum = Vec3::Zero();  // at close packing, all particles [N s]
  Vec3 wall_impulse = Vec3::Zero();   // taken by the walls, all particles [N s]
};

class ParcelMotion {
 public:
  static constexpr double soft_limit = 0.995;  // in close packings
  static constexpr double hard_limit = 1.01;
  static constexpr int even_passes = 3;   // while a cell is above its soft limit
  static constexpr int soft_passes = 12;  // while a cell is above its hard limit
  static constexpr int most_passes = 200;

  explicit ParcelMotion(double close_packing) : close_packing_(close_packing) {}

  // Collective. Positions and velocities of the view are changed.
  MotionReport move(const ParcelView& parcels, const TileFrame& frame, double dt,
                    const Walls& walls, const SumOverRanks& sum, const TotalOverRanks& total);

  // After the last step, over its tile.
  [[nodiscard]] const Array3<double>& solid_fraction() const { return fraction_; }

 private:
  struct Way {
    Vec3 start;
    Vec3 way;
    Vec3 velocity;              // after rebounds
    Vec3 alpha = Vec3::Ones();  // share of the way that is gone, along each axis
    double fraction = 0.0;      // solid volume over that of a cell; 0: takes no part
    bool stopped = false;

    [[nodiscard]] Vec3 end() const { return start + alpha.cwiseProduct(way); }
  };

  void find_ways(const ParcelView& parcels, const TileFrame& frame, double dt, const Walls& walls,
                 MotionReport& report);
  void deposit_ways(const TileFrame& frame, const SumOverRanks& sum);
  [[nodiscard]] double limit(std::size_t cell, double packings) const;
  [[nodiscard]] bool any_above(double packings) const;
  void mark_above(const TileFrame& frame, double packings);
  void find_shares(const TileFrame& frame, const SumOverRanks& sum);
  void shorten_ways(const TileFrame& frame, const SumOverRanks& sum, bool hard);
  void hold_all(const TileFrame& frame);
  void set_velocities(const ParcelView& parcels, const TileFrame& frame, double dt,
                      const SumOverRanks& sum, MotionReport& report);

  double close_packing_;
  std::vector<Way> ways_;
  Array3<double> before_;    // fraction as the step began
  Array3<double> fraction_;  // at the ends of the ways
  Array3<double> change_;    // of the fraction by a pass
  Array3<double> inflow_;    // in fractions
  Array3<double> outflow_;
  Array3<double> share_;  // alpha of a marked cell; above 1: not marked
  Array3<char> touched_;  // lowest cells of the stencils that have a marked cell
  Array3<double> mass_;
  std::array<Array3<double>, 3> momentum_;
};

}  // namespace gasgrain
