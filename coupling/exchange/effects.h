// The effects that a scene names, read from the words of its line, for instance
//   drag koch_hill void_fraction offset pressure_gradient
// `drag` and `void_fraction` take one name; a force is switched on by its bare name.
//
// Without a void_fraction word the method is trilinear: it is the one whose void fraction is
// continuous as particles move, so that the gas sees no spikes of d eps / dt. Without a drag word
// there is no drag: an effect that is not named is absent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/exchange/drag/models.h"
#include "coupling/exchange/forces/forces.h"
#include "coupling/exchange/gas_fields.h"
#include "coupling/exchange/void_fraction/methods.h"

namespace gasgrain {

struct Effects {
  VoidFractionMethod method = VoidFractionTrilinear{};
  std::optional<DragModel> drag;
  std::vector<Force> forces;  // in the order of the scene, none twice

  // Fields that the gas must lend for these effects, and fields that it must take.
  [[nodiscard]] FieldSet lent() const;
  [[nodiscard]] FieldSet taken() const;
  // The words of a line that means the same, defaults written out.
  [[nodiscard]] std::string text() const;
};

// Throws one Error with all faults, a line each, each beginning with `where` (file and line, or the
// command, of the words).
Effects parse_effects(const std::vector<std::string>& words, const std::string& where);

}  // namespace gasgrain
