// The story of a coupled step, seen from the DEM ranks; the host adaptors call it and nothing else.
//
//   begin  at a coupling, every N DEM steps:
//            the particles' volume is deposited and sent; the void fraction comes back;
//            K of each particle from it and from the last gas velocity; K and S deposited and sent;
//            the gas advances over the coming interval; its mean velocity and pressure gradient
//            come back and are sampled at the particles; the ledger books what the gas gave
//   apply  at every DEM step: the forces, with each particle's own, current velocity
//
// One CoupledStep a DEM rank; begin() and the constructor are collective over both programs.
#pragma once

#include <mpi.h>

#include <optional>

#include "coupling/base/cost_ledger.h"
#include "coupling/exchange/effects.h"
#include "coupling/exchange/ledger.h"
#include "coupling/exchange/particle_exchange.h"
#include "coupling/transport/protocol.h"
#include "coupling/transport/route.h"

namespace gasgrain {

// The host's side of the first meeting.
struct DemScene {
  Vec3 box_lo = Vec3::Zero();  // [m]
  Vec3 box_hi = Vec3::Zero();
  std::array<int, 3> periodic{};
  double interval = 0.0;  // coupling interval [s]
  double time = 0.0;      // gas time of the first coupling to come [s]
};

// The part of the box that a DEM rank's particles may be in until the next coupling.
struct DemRegion {
  Vec3 lo = Vec3::Zero();  // of the rank's sub-domain [m]
  Vec3 hi = Vec3::Zero();
  double drift = 0.0;           // how far beyond it a particle may be [m]
  double largest_radius = 0.0;  // [m], of all ranks
};

class CoupledStep {
 public:
  // Meets the gas program; throws Error with all faults when the two do not fit.
  CoupledStep(const Communicator& local, MPI_Comm partner, const Effects& effects,
              const DemScene& scene);

  // Couples over the coming interval [s] from gas time `time`. `records`: one per particle.
  // Returns the gas's report (on rank 0; empty elsewhere).
  Report begin(const ParticleView& particles, const DemRegion& region, ExchangeRecord* records,
               double interval, long step, double time);

  // Adds this moment's forces; `dt`: the time for which the host lets them act [s].
  void apply(const ParticleView& particles, ExchangeRecord* records, double* force, double dt);

  // Asks the gas for a checkpoint that belongs to this DEM step; returns when it is whole on disk.
  void checkpoint(long step);
  // The orderly end: the gas finishes its files and stops.
  void finish();

  // The ledger of all ranks. Collective.
  [[nodiscard]] Ledger whole_ledger(const ParticleView& particles,
                                    const ExchangeRecord* records) const;
  // Goes on from a restart: the records are the stored ones, `ledger_values` those of the whole
  // ledger (rank 0 keeps them).
  void resume(const ParticleView& particles, const ExchangeRecord* records,
              const std::vector<double>& ledger_values);

  [[nodiscard]] const GasHello& gas() const { return gas_; }
  [[nodiscard]] const BoxGrid& grid() const { return frame_.grid; }
  [[nodiscard]] CostLedger& costs() { return costs_; }
  // What was clamped since the last call, this rank's share.
  struct Clamps {
    long too_dense = 0;  // particles whose void fraction was raised to the least a drag law takes
    long beyond_walls = 0;  // particles whose centre was outside of the box
  };
  Clamps take_clamps();

 private:
  [[nodiscard]] IndexBox tile_of(const DemRegion& region) const;
  void make_tile(const IndexBox& tile);
  void settle(const ParticleView& particles, const ExchangeRecord* records);
  [[nodiscard]] FieldList lent_fields();

  Communicator local_;
  MPI_Comm partner_;
  Effects effects_;
  GasHello gas_;
  TileFrame frame_;
  RouteTransport transport_;
  ParticleWeights weights_;
  Ledger ledger_;
  CostLedger costs_;
  Clamps clamps_;
  Vec3 taken_in_interval_ = Vec3::Zero();  // this rank's particles, since the last coupling
  Vec3 expected_in_interval_ = Vec3::Zero();
  bool met_before_ = false;

  // Over the tile
  Array3<double> solid_volume_, void_fraction_, drag_coefficient_;
  VectorField drag_source_, velocity_, pressure_gradient_;

  std::size_t cost_deposit_, cost_drag_, cost_transport_, cost_wait_, cost_sample_, cost_forces_;
};

}  // namespace gasgrain
