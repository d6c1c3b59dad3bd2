// The stacks of contact laws that are compiled, by name. A host asks for one when it reads a
// script; what is not compiled is refused with a list of what is.
//
// compiled_stacks.h says which; the build makes a file for each cohesion law of the LIST, and a law
// that is built elsewhere adds its own with add_stacks_with().
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_stack.h"

namespace gasgrain::contact {

// Visible to laws that are built elsewhere.
class [[gnu::visibility("default")]] ContactStacks {
 public:
  using Maker = std::unique_ptr<ContactStack> (*)(bool of_wall);

  static ContactStacks& known();  // those of the LISTs, and what was added

  void add(const StackName& name, Maker maker) {
    makers_[name] = maker;
  }
  // Throws Error, with the nearest name or what is compiled with this cohesion.
  [[nodiscard]] std::unique_ptr<ContactStack> make(const StackName& name, bool of_wall) const;

 private:
  [[nodiscard]] std::vector<std::string> names(std::string StackName::*part,
                                               const std::string& cohesion) const;
  std::map<StackName, Maker> makers_;
};

}  // namespace gasgrain::contact
