// The effects that a scene names, read from the words of its line, for instance
//   drag koch_hill void_fraction offset pressure_gradient
// `drag`, `momentum_sharing` and `self_disturbance` take one name, `void_fraction` one name and for
// some of them a number; a force and `polydisperse` are switched on by their bare names.
//
// Without a void_fraction word the method is chosen at the first coupling, when the sizes of the
// particles are known (choose_method.h). Without a drag word there is no drag: an effect that is
// not named is absent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/exchange/drag/models.h"
#include "coupling/exchange/exchange_record.h"
#include "coupling/exchange/forces/forces.h"
#include "coupling/exchange/gas_fields.h"
#include "coupling/exchange/momentum_sharing.h"
#include "coupling/exchange/void_fraction/read_method.h"

namespace gasgrain {

struct Effects {
  VoidFractionMethod method = VoidFractionTrilinear{};
  bool choose_method = true;  // the method is to be chosen; until then `method` stands in
  std::optional<DragModel> drag;
  double drag_factor = 1.0;   // on the law's K: of grains that go in clusters, below 1
  bool polydisperse = false;  // the drag law is corrected for a mixture of sizes
  MomentumSharing sharing;
  bool ignore_self_disturbance = false;  // `self_disturbance ignored`: what it costs and changes
  std::vector<Force> forces;             // in the order of the scene, none twice

  // Fields that the gas must lend for these effects, and fields that it must take.
  [[nodiscard]] FieldSet lent() const;
  [[nodiscard]] FieldSet taken() const;
  // Names of what is on, drag first, in the order of the scene: the order of the ledger's sums.
  [[nodiscard]] std::vector<std::string> names() const;
  // Of momentum_sharing.h.
  [[nodiscard]] bool by_mean_velocity() const;
  [[nodiscard]] bool own_drag() const;
  // True when some force's impulse is taken from the gas.
  [[nodiscard]] bool any_reacts() const;
  // What a particle's record must hold. `overlapped`: the gas's answer comes an interval later.
  [[nodiscard]] RecordLayout layout(bool overlapped) const;
  // The words of a line that means the same, the void-fraction method written out.
  [[nodiscard]] std::string text() const;
};

// The words that begin an effect: those that take a name, then the forces.
std::vector<std::string> effect_words();

// Throws one Error with all faults, a line each, each beginning with `where` (file and line, or the
// command, of the words).
Effects parse_effects(const std::vector<std::string>& words, const std::string& where);

}  // namespace gasgrain
