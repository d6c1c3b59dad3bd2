// The words of a contact in a script of LIGGGHTS and the stack of laws that is compiled for them,
// of our pair style and of walls beside it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_words.h"
#include "fix_cfd_coupling/liggghts/contact_host_liggghts.h"

namespace gasgrain {

class CompiledContact {
 public:
  // Throws Error with all faults of the words, or with the list of what is compiled.
  CompiledContact(std::vector<std::string> words, bool of_wall);

  // Takes the properties of the scene; `place` is the pair style or the wall.
  void connect(LAMMPS_NS::LAMMPS& host, LIGGGHTS::IContactHistorySetup& place);
  [[nodiscard]] contact::ContactStack& stack() const { return *choice_.stack; }

 private:
  bool frictionless_;
  contact::ContactChoice choice_;
  std::vector<std::unique_ptr<ContactHostLiggghts>> hosts_;  // one for each law
};

}  // namespace gasgrain
