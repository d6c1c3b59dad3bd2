#include "fix_cfd_coupling/dem_physics/contact/contact_stacks.h"

#include <algorithm>

#include "coupling/base/error.h"

namespace gasgrain::contact {

// Of all stacks, or of those with this cohesion.
std::vector<std::string> ContactStacks::names(std::string StackName::*part,
                                              const std::string& cohesion) const {
  std::vector<std::string> found;
  for (const auto& [name, maker] : makers_)
    if ((cohesion.empty() || name.cohesion == cohesion) &&
        std::find(found.begin(), found.end(), name.*part) == found.end())
      found.push_back(name.*part);
  return found;
}

std::unique_ptr<ContactStack> ContactStacks::make(const StackName& name, bool of_wall) const {
  const auto at = makers_.find(name);
  if (at != makers_.end()) return at->second(of_wall);
  struct Kind {
    const char* word;
    std::string StackName::*part;
  };
  constexpr Kind kinds[] = {{"model", &StackName::normal},
                            {"tangential", &StackName::tangential},
                            {"rolling_friction", &StackName::rolling},
                            {"cohesion", &StackName::cohesion}};
  std::string faults;
  for (const Kind& kind : kinds) {
    const auto all = names(kind.part, "");
    if (std::find(all.begin(), all.end(), name.*kind.part) == all.end())
      faults += fmt::format("\n{} \"{}\" is unknown.{}", kind.word, name.*kind.part,
                            suggestion(name.*kind.part, all));
  }
  if (!faults.empty()) throw Error(faults.substr(1));
  std::string known;
  for (const auto& [other, maker] : makers_)
    if (other.cohesion == name.cohesion)
      known += fmt::format("\n  model {} tangential {} rolling_friction {}", other.normal,
                           other.tangential, other.rolling);
  fail("model {} tangential {} rolling_friction {} is not compiled with cohesion {}. These are:{}",
       name.normal, name.tangential, name.rolling, name.cohesion, known);
}

}  // namespace gasgrain::contact
