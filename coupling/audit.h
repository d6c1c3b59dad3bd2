// The audit of a run: how large each effect was, or would have been where it was off.
//
// At a coupling one pass over the grains takes the scales of each (slip, spin, shear, ...) and from
// them the sizes of all effects (exchange/effect_sizes). What the gas was not asked to lend is
// taken from the velocities in the cells about the grain: curl u, u . grad u (for Du/Dt, without
// du/dt), mu lap u (for div tau); grad p from what drag and the gas's acceleration ask for. So
// contacts and what happens between couplings are not in it. Without drag no gas velocity is lent
// and nothing of the gas is known.
//
// An effect is needed where it is at least `needed_share` of the greater of weight and drag, for at
// least `needed_often` of the grains seen.
#pragma once

#include <string>
#include <vector>

#include "coupling/base/communicator.h"
#include "coupling/exchange/effect_sizes/scales.h"
#include "coupling/exchange/effects.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/field_store.h"
#include "coupling/exchange/particle_view.h"

namespace gasgrain {

inline constexpr double needed_often = 0.01;

// What the estimates need of a coupling beside the grains and the fields.
struct AuditSetting {
  GasProperties gas{};
  double gravity = 0.0;   // [m/s2]
  double interval = 0.0;  // [s]
  bool overlapped = false;
};

class Audit {
 public:
  Audit() = default;
  explicit Audit(const Effects& effects);

  // After the records have the gas of this coupling.
  void look(const ParticleView& particles, const ExchangeRecords& records, const FieldStore& fields,
            const TileFrame& frame, const AuditSetting& setting);

  // Of one effect, over all grains at all couplings seen.
  struct Seen {
    std::string name;
    double force = 0.0;     // sum [N]
    double needed = 0.0;    // grains for which it was needed_share or more
    double greatest = 0.0;  // share of the greater of weight and drag
  };
  // The greatest of all grains.
  struct Extremes {
    double slip = 0.0;              // [m/s]
    double speed = 0.0;             // [m/s]
    double spin = 0.0;              // [rad/s]
    double vorticity = 0.0;         // [1/s]
    double gas_acceleration = 0.0;  // [m/s2]
    double reynolds = 0.0;
    double diameter = 0.0;         // [m]
    double largest_inverse = 0.0;  // of the smallest diameter [1/m]
  };

  // Adds up what all ranks have seen. Collective.
  [[nodiscard]] Audit whole(const Communicator& ranks) const;

  [[nodiscard]] const std::vector<Seen>& seen() const { return seen_; }
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }
  [[nodiscard]] double grains() const { return grains_; }  // seen, summed over couplings
  [[nodiscard]] double drag() const { return drag_; }      // sum [N]
  [[nodiscard]] double weight() const { return weight_; }  // sum [N]
  [[nodiscard]] long couplings() const { return couplings_; }
  // Fields that were estimated because nobody lends them.
  [[nodiscard]] FieldSet estimated() const { return estimated_; }
  [[nodiscard]] bool gas_known() const { return gas_known_; }

 private:
  void take(const Scales& at);

  std::vector<Seen> seen_;
  Extremes extremes_;
  Effects effects_;
  double grains_ = 0.0;
  double drag_ = 0.0;
  double weight_ = 0.0;
  double volume_ = 0.0;  // of the grains' cubes d^3, and d^2, for Sauter's diameter
  double surface_ = 0.0;
  long couplings_ = 0;
  FieldSet estimated_;
  bool gas_known_ = false;
};

}  // namespace gasgrain
