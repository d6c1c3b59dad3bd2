// The story of a coupled step, seen from the DEM ranks; the host adaptors call it and nothing else.
//
//   begin  at a coupling, every N DEM steps:
//            the particles' volume is deposited and sent; the void fraction comes back;
//            K of each particle from it and from the last gas velocity; K and S deposited and sent;
//            the gas advances over the coming interval; its mean velocity and pressure gradient
//            come back and are sampled at the particles; the ledger books what the gas gave
//   apply  at every DEM step: the forces, with each particle's own, current velocity
//
// In turn, begin() waits for the gas. Overlapped, it does not: the gas advances while the DEM steps
// go on with the gas fields of the interval before, and the next begin() takes its answer first.
// The ledger then books each particle's share where it was when the gas was charged.
//
// The gas is another program of the launch, or works inside the DEM ranks: then always in turn.
//
// One CoupledStep a DEM rank; begin(), checkpoint(), finish() and the constructor are collective
// over the ranks of both.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/cost_ledger.h"
#include "coupling/exchange/applied_forces.h"
#include "coupling/exchange/effects.h"
#include "coupling/exchange/ledger.h"
#include "coupling/exchange/particle_exchange.h"
#include "coupling/interval_check.h"
#include "coupling/transport/gas_partner.h"

namespace gasgrain {

// The host's side of the first meeting.
struct DemScene {
  Vec3 box_lo = Vec3::Zero();  // [m]
  Vec3 box_hi = Vec3::Zero();
  std::array<int, 3> periodic{};
  double interval = 0.0;  // coupling interval [s]
  double time = 0.0;      // gas time of the first coupling to come [s]
  bool overlapped = false;
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
  // Meets the gas; throws Error with all faults when the two do not fit.
  CoupledStep(const Communicator& local, std::unique_ptr<GasPartner> partner,
              const Effects& effects, const DemScene& scene);

  // Couples over the coming interval [s] from gas time `time`. `records`: one per particle.
  // Throws RunFault on every rank when the gas says that it cannot go on.
  void begin(const ParticleView& particles, const DemRegion& region, ExchangeRecords& records,
             double interval, long step, double time);

  // Adds this moment's forces; dt: the host's step [s], share: of it that they will act.
  void apply(const ParticleView& particles, ExchangeRecords& records, const HostForces& host,
             double dt, double share);

  // Takes the gas's answer if it is still to come. Before a checkpoint, and at the end of a run.
  void complete(const ParticleView& particles, ExchangeRecords& records);
  // The gas's last report (on rank 0; empty elsewhere).
  [[nodiscard]] const Report& report() const { return report_; }

  // Asks the gas for a checkpoint that belongs to this DEM step; returns when it is whole on disk.
  void checkpoint(long step);
  // The same of a run that has gone wrong, beside the good ones. Empty, or why there is none (on
  // rank 0).
  [[nodiscard]] std::string autopsy(long step);
  // The orderly end: the gas finishes its files and stops. Returns what it spent its time on, a
  // JSON object (on rank 0; empty elsewhere).
  std::string finish();

  // The ledger of all ranks. Collective.
  [[nodiscard]] Ledger whole_ledger(const ParticleView& particles,
                                    const ExchangeRecords& records) const;
  // Goes on from a restart: the records are the stored ones, `ledger_values` those of the whole
  // ledger (rank 0 keeps them).
  void resume(const ParticleView& particles, const ExchangeRecords& records,
              const std::vector<double>& ledger_values, const Report& last);

  [[nodiscard]] const GasHello& gas() const { return gas_; }
  [[nodiscard]] const BoxGrid& grid() const { return frame_.grid; }
  // Of the last coupling, for those who look on: what was lent, over the tile of the frame.
  [[nodiscard]] const FieldStore& fields() const { return fields_; }
  [[nodiscard]] const TileFrame& frame() const { return frame_; }
  [[nodiscard]] const GasProperties& properties() const { return properties_; }
  [[nodiscard]] CostLedger& costs() { return costs_; }
  // What was clamped since the last call, this rank's share.
  struct Clamps {
    long too_dense = 0;  // particles whose void fraction was raised to the least a drag law takes
    long beyond_walls = 0;     // particles whose centre was outside of the box
    long disturbance_cut = 0;  // particles whose own disturbance is beyond what can be undone
  };
  Clamps take_clamps();
  // What the grains of the last begin() ask of the interval, this rank's share.
  [[nodiscard]] const IntervalNeed& interval_need() const { return interval_need_; }
  // Bytes of fields that this rank sent and received since the last call.
  [[nodiscard]] long take_bytes();

 private:
  void settle_method(const ParticleView& particles, const DemRegion& region);
  [[nodiscard]] IndexBox tile_of(const DemRegion& region) const;
  void make_tile(const IndexBox& tile);
  void settle(const ParticleView& particles, const ExchangeRecords& records);
  void make_tasks();
  void deposit(const ParticleView& particles);
  void exchange_solids(bool fresh);
  void charge_gas(const ParticleView& particles, ExchangeRecords& records);
  void look_at_interval(const ParticleView& particles, const ExchangeRecords& records);
  void receive_answer();
  void book_where_charged(const ParticleView& particles, ExchangeRecords& records);
  [[nodiscard]] Vec3 charged_to_gas() const;

  Communicator local_;
  std::unique_ptr<GasPartner> partner_;
  Effects effects_;
  bool overlapped_;
  GasHello gas_;
  GasProperties properties_;
  TileFrame frame_;
  RouteTransport transport_;
  ParticleWeights weights_;
  ForceLoop forces_;
  Ledger ledger_;
  CostLedger costs_;
  Clamps clamps_;
  IntervalNeed interval_need_;
  Report report_;
  double interval_ = 0.0;                     // of the last coupling [s]
  Vec3 expected_in_interval_ = Vec3::Zero();  // by this rank's particles, less what they owed
  bool met_before_ = false;
  bool method_settled_ = false;
  bool answer_to_come_ = false;
  long bytes_ = 0;
  FieldStore fields_;  // over the tile

  std::size_t cost_deposit_, cost_transport_, cost_wait_, cost_sample_, cost_look_;
  std::size_t cost_drag_ = 0;
  std::size_t cost_charge_ = 0;
  std::vector<std::size_t> cost_forces_;  // by ForceCosts' rows
};

}  // namespace gasgrain
