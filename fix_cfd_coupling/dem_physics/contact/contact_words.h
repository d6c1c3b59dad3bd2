// The words of a contact in a host's script, in LIGGGHTS's form or that of LAMMPS's own granular
// styles, and the stack of laws that they ask for.
//
//   model NAME tangential NAME [rolling_friction NAME] [cohesion NAME] [surface default] [WORD
//   VALUE]... hertz/history Kn Kt gamma_n gamma_t xmu dampflag [limit_damping] [cohesion NAME]
//   [WORD VALUE]...
//
// hooke/history is read as hertz/history. There `NULL` for Kt is 2/7 Kn, for gamma_t half of
// gamma_n, and dampflag 0 sets gamma_t to 0, as LAMMPS has it. Units: kn, kt [Pa] (hooke: [N/m]),
// gamma_n, gamma_t [1/(m s)] (hooke: [1/s]).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_stack.h"

namespace gasgrain::contact {

struct ContactChoice {
  StackName name;
  std::unique_ptr<ContactStack> stack;  // its words are set
  // Properties that stand among the words, under LIGGGHTS's names: of all types alike.
  std::map<std::string, double> properties;
};

// Throws Error with all faults of the words.
ContactChoice read_contact(const std::vector<std::string>& words, bool of_wall);

}  // namespace gasgrain::contact
