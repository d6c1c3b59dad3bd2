// The words of a scene that name a void-fraction method: `auto`, or a name of the LIST, which
// `kernel` and `particle_grid` may have a number after, a width in particle diameters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/exchange/void_fraction/methods.h"

namespace gasgrain {

struct NamedMethod {
  // Where `automatic` is set this one stands in until the sizes of particles are known.
  VoidFractionMethod method = VoidFractionTrilinear{};
  bool automatic = true;

  // The words that mean the same, numbers written out.
  [[nodiscard]] std::string text() const;
};

std::vector<std::string> method_names();

struct MethodWords {
  std::optional<NamedMethod> named;
  std::string fault;      // empty when there is a method
  std::size_t taken = 0;  // words read
};

// Reads from words[next] on. `others`: words that begin another effect and are no names.
MethodWords read_method(const std::vector<std::string>& words, std::size_t next,
                        const std::vector<std::string>& others);

}  // namespace gasgrain
